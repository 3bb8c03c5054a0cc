// Numbers in the machine's own order, one after the other: a store never leaves its machine.
#include "compiler/aspects/view_codec.h"

#include <cstring>
#include <type_traits>

namespace aspect {
namespace {

class Writer {
 public:
  template <typename T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto* first = reinterpret_cast<const std::byte*>(&value);
    bytes.insert(bytes.end(), first, first + sizeof value);
  }
  std::vector<std::byte> bytes;
};

class Reader {
 public:
  explicit Reader(std::span<const std::byte> from) : bytes_(from) {}
  template <typename T>
  void get(T& value) {
    if (bytes_.size() < sizeof value) {
      failed = true;
      return;
    }
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_ = bytes_.subspan(sizeof value);
  }
  std::uint32_t get_count(std::uint32_t most) {
    std::uint32_t count = 0;
    get(count);
    if (count > most) failed = true;
    return failed ? 0 : count;
  }
  bool at_end() const { return bytes_.empty(); }
  bool failed = false;

 private:
  std::span<const std::byte> bytes_;
};

constexpr std::uint32_t kMostContours = 4096, kMostSurfaces = 65536, kMostRelations = 1U << 24U;

void put_contour(Writer& writer, const ObservedContour& contour) {
  writer.put(contour.feature);
  writer.put(static_cast<std::uint8_t>(contour.external));
  writer.put(contour.shape);
  writer.put(contour.area_px);
  writer.put(contour.centre_object);
  writer.put(static_cast<std::uint32_t>(contour.surfaces.size()));
  for (const SurfaceShare& share : contour.surfaces) {
    writer.put(share.surface);
    writer.put(share.pixels);
  }
}

ObservedContour get_contour(Reader& reader) {
  ObservedContour contour;
  std::uint8_t external = 0;
  reader.get(contour.feature);
  reader.get(external);
  reader.get(contour.shape);
  reader.get(contour.area_px);
  reader.get(contour.centre_object);
  contour.external = external != 0;
  const std::uint32_t count = reader.get_count(kMostSurfaces);
  for (std::uint32_t i = 0; i < count && !reader.failed; ++i) {
    SurfaceShare share;
    reader.get(share.surface);
    reader.get(share.pixels);
    contour.surfaces.push_back(share);
  }
  return contour;
}

}  // namespace

std::vector<std::byte> encode_view(const ObservedView& view) {
  Writer writer;
  for (const double x : view.right) writer.put(x);
  writer.put(view.area_px);
  writer.put(static_cast<std::uint32_t>(view.contours.size()));
  for (const ObservedContour& contour : view.contours) put_contour(writer, contour);
  writer.put(static_cast<std::uint32_t>(view.relations.size()));
  for (const Relation& relation : view.relations) {
    writer.put(relation.from);
    writer.put(relation.to);
    writer.put(relation.direction);
    writer.put(relation.kind);
  }
  return std::move(writer.bytes);
}

std::optional<ObservedView> decode_view(const Eigen::Vector3d& direction,
                                        std::span<const std::byte> bytes) {
  Reader reader(bytes);
  ObservedView view;
  view.direction = direction;
  for (double& x : view.right) reader.get(x);
  reader.get(view.area_px);
  const std::uint32_t contours = reader.get_count(kMostContours);
  for (std::uint32_t i = 0; i < contours && !reader.failed; ++i) {
    view.contours.push_back(get_contour(reader));
    if (view.contours.back().external) view.external_count = view.contours.size();
  }
  const std::uint32_t relations = reader.get_count(kMostRelations);
  for (std::uint32_t i = 0; i < relations && !reader.failed; ++i) {
    Relation relation;
    reader.get(relation.from);
    reader.get(relation.to);
    reader.get(relation.direction);
    reader.get(relation.kind);
    if (relation.from >= view.external_count || relation.to >= view.external_count)
      reader.failed = true;
    view.relations.push_back(relation);
  }
  if (reader.failed || !reader.at_end()) return std::nullopt;
  return view;
}

std::vector<std::byte> encode_mapping(const GraphMatch& match) {
  std::vector<std::byte> bytes(match.mapping.size());
  std::memcpy(bytes.data(), match.mapping.data(), bytes.size());
  return bytes;
}

GraphMatch decode_match(double cost, std::span<const std::byte> mapping) {
  GraphMatch match;
  match.cost = cost;
  match.mapping.resize(mapping.size());
  std::memcpy(match.mapping.data(), mapping.data(), mapping.size());
  return match;
}

}  // namespace aspect
