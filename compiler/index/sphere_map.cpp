#include "compiler/index/sphere_map.h"

#include <bit>

namespace aspect {
namespace {

constexpr int kDeepestLevel = 12;
constexpr std::size_t kMostPatches = 1U << 22U;

// Class numbers are written plus one, so that 0 stands for none.
int class_bits(std::size_t class_count) {
  return static_cast<int>(std::bit_width(class_count));
}

class BitWriter {
 public:
  void put(std::uint32_t value, int bits) {
    for (int bit = bits - 1; bit >= 0; --bit) {
      if (used_ % 8 == 0) bytes.push_back(0);
      bytes.back() =
          static_cast<std::uint8_t>(bytes.back() | ((value >> bit) & 1U) << (7 - used_ % 8));
      ++used_;
    }
  }
  std::vector<std::uint8_t> bytes;

 private:
  std::size_t used_ = 0;
};

class BitReader {
 public:
  explicit BitReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint32_t get(int bits) {
    std::uint32_t value = 0;
    for (int bit = 0; bit < bits; ++bit, ++used_) {
      failed = failed || used_ / 8 >= bytes_.size();
      const std::uint32_t byte = failed ? 0U : bytes_[used_ / 8];
      value = value << 1U | ((byte >> (7 - used_ % 8)) & 1U);
    }
    return value;
  }
  bool failed = false;

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t used_ = 0;
};

constexpr std::size_t kRoots = 20;
PatchId root(std::size_t k) {
  return static_cast<PatchId>(k);
}
std::size_t number(PatchId patch) {
  return static_cast<std::size_t>(patch);
}

struct Encoder {
  const ViewSphere& sphere;
  std::span<const std::int32_t> class_of;
  int bits;
  int level;
  BitWriter out;
  std::int32_t last = kNoClass;

  std::int32_t common_class(PatchId id) const {
    const Patch& patch = sphere.patch(id);
    if (!patch.split) return class_of[number(id)];
    const std::int32_t first = common_class(patch.children[0]);
    for (const PatchId child : patch.children)
      if (common_class(child) != first) return kNoClass;
    return first;
  }

  void put(PatchId id) {
    const Patch& patch = sphere.patch(id);
    const bool split = patch.split && patch.level < level;
    out.put(split ? 1 : 0, 1);
    if (split) {
      for (const PatchId child : patch.children) put(child);
      return;
    }
    const std::int32_t own = common_class(id);
    out.put(own == last ? 1 : 0, 1);
    if (own != last) out.put(static_cast<std::uint32_t>(own + 1), bits);
    last = own;
  }
};

struct Decoder {
  SphereMap& map;
  BitReader in;
  std::size_t class_count;
  std::int32_t last = kNoClass;

  void get(PatchId id) {
    if (in.failed) return;
    map.class_of.resize(map.sphere.patch_count(), kNoClass);
    if (in.get(1) == 1) {
      if (map.sphere.patch(id).level >= kDeepestLevel || map.sphere.patch_count() > kMostPatches) {
        in.failed = true;
        return;
      }
      map.sphere.split(id);
      const auto children = map.sphere.patch(id).children;
      for (const PatchId child : children) get(child);
      return;
    }
    if (in.get(1) == 0) last = static_cast<std::int32_t>(in.get(class_bits(class_count))) - 1;
    in.failed = in.failed || last >= static_cast<std::int32_t>(class_count);
    map.class_of[number(id)] = last;
  }
};

}  // namespace

std::vector<std::uint8_t> encode_sphere_map(const ViewSphere& sphere,
                                            std::span<const std::int32_t> class_of,
                                            std::size_t class_count, int level) {
  Encoder encoder{sphere, class_of, class_bits(class_count), level, {}};
  for (std::size_t k = 0; k < kRoots; ++k) encoder.put(root(k));
  return std::move(encoder.out.bytes);
}

std::vector<std::uint8_t> encode_sphere_map_within(const ViewSphere& sphere,
                                                   std::span<const std::int32_t> class_of,
                                                   std::size_t class_count,
                                                   std::size_t most_bytes) {
  int deepest = 0;
  for (std::size_t i = 0; i < sphere.patch_count(); ++i)
    deepest = std::max(deepest, sphere.patch(static_cast<PatchId>(i)).level);
  for (int level = deepest; level > 0; --level) {
    std::vector<std::uint8_t> bytes = encode_sphere_map(sphere, class_of, class_count, level);
    if (bytes.size() <= most_bytes) return bytes;
  }
  return encode_sphere_map(sphere, class_of, class_count, 0);
}

Result<SphereMap> decode_sphere_map(std::span<const std::uint8_t> bytes, std::size_t class_count) {
  SphereMap map;
  Decoder decoder{map, BitReader(bytes), class_count};
  for (std::size_t k = 0; k < kRoots; ++k) decoder.get(root(k));
  if (decoder.in.failed)
    return Error{"its map of the viewing sphere is damaged; compile the scene again"};
  map.class_of.resize(map.sphere.patch_count(), kNoClass);
  return map;
}

}  // namespace aspect
