#include "tests/tools/tiny_index.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <span>
#include <vector>

#include "runtime/recognition/class_index.h"
#include "runtime/vision/vision.h"
#include "schema/class_index_generated.h"

namespace aspect {
namespace {

namespace fb = ::aspect::schema;

struct Parts {
  std::vector<float> types;
  std::vector<fb::ClassContour> contours;
  std::vector<fb::TypeScore> scores;
  std::vector<fb::KeyContour> key_contours;
};

std::int16_t packed(float value, float unit) {
  return static_cast<std::int16_t>(std::lround(value * unit));
}

void add_contour(const ContourFeature& feature, Parts& parts) {
  const auto name = static_cast<std::uint16_t>(parts.contours.size());
  const auto share = [&](std::size_t k) {
    return static_cast<std::uint8_t>(std::lround(255 * feature.share[k]));
  };
  for (const float attribute : type_attributes(feature)) parts.types.push_back(attribute);
  parts.scores.emplace_back(1.0F, name, std::uint16_t{0});
  parts.contours.emplace_back(name, std::uint16_t{1}, std::uint16_t{0}, std::uint8_t{0}, share(0),
                              share(1), share(2), 0.0F, 0.0F, 0.0F);
  const Moments& m = feature.moments;
  constexpr float kPosition = 8192, kSecond = 4096, kThird = 16384;
  parts.key_contours.emplace_back(
      packed(feature.position.x, kPosition), packed(feature.position.y, kPosition),
      static_cast<std::uint16_t>(std::lround(65535 * feature.area)), packed(m.xx, kSecond),
      packed(m.xy, kSecond), packed(m.yy, kSecond), packed(m.xxx, kThird), packed(m.xxy, kThird),
      packed(m.xyy, kThird), packed(m.yyy, kThird), name);
}

Parts describe_picture(const cv::Mat& picture, VisionParameters parameters) {
  parameters.one_blob = true;
  Arena counted;
  Vision().prepare(counted, picture.cols, picture.rows);
  std::vector<std::byte> storage(counted.used_bytes() + 64);
  Arena arena(storage);
  Vision vision;
  vision.prepare(arena, picture.cols, picture.rows);
  const Frame frame = {picture.data, picture.cols, picture.rows, std::ptrdiff_t{3} * picture.cols,
                       PixelFormat::bgr8};
  const ViewGraph graph = vision.run(frame, parameters);
  Parts parts;
  for (const Contour& contour : graph.contours)
    if (contour.external) add_contour(feature_of(contour, graph.blobs[contour.blob]), parts);
  return parts;
}

void sign(std::span<std::uint8_t> file) {
  auto* root = flatbuffers::GetMutableRoot<fb::ClassIndex>(file.data());
  const auto* table = reinterpret_cast<const flatbuffers::Table*>(root);
  const std::uint8_t* field = table->GetAddressOf(fb::ClassIndex::VT_CHECKSUM);
  const auto place = static_cast<std::size_t>(field - file.data());
  const std::uint64_t sum = index_checksum(std::as_bytes(file), place);
  std::memcpy(file.data() + place, &sum, sizeof sum);
}

}  // namespace

void write_tiny_index(const std::filesystem::path& file, const std::string& object,
                      const cv::Mat& picture, const VisionParameters& parameters) {
  const Parts parts = describe_picture(picture, parameters);
  const auto count = static_cast<std::uint16_t>(parts.contours.size());
  const fb::Direction view(0, 0, 32767);
  const std::vector classes = {fb::AspectClass(0, count, 0, 1, 1.0F, 1, view)};
  const std::vector views = {fb::KeyView(0, count, view)};

  flatbuffers::FlatBufferBuilder builder;
  const auto provenance = fb::CreateProvenanceDirect(builder, "tiny_index");
  const auto segmentation =
      fb::CreateSegmentation(builder, static_cast<std::uint16_t>(parameters.intensity_min),
                             static_cast<std::uint8_t>(parameters.chroma_step),
                             static_cast<std::uint8_t>(parameters.noise_steps),
                             static_cast<std::uint16_t>(parameters.intensity_step),
                             static_cast<std::uint32_t>(parameters.area_min_px),
                             parameters.thickness_min_px, parameters.smooth);
  const std::vector<std::uint16_t> no_surfaces;
  const std::vector<std::uint8_t> no_map(5, 0x55);  // 20 patches, unsplit and of no class
  // A field that has its default value is not stored at all; the real checksum replaces this one.
  constexpr std::uint64_t kPlaceholder = 1;
  builder.Finish(
      fb::CreateClassIndexDirect(
          builder, kIndexFormatVersion, kPlaceholder, object.c_str(), provenance, segmentation,
          fb::Scoring::none, 50, static_cast<std::uint16_t>(picture.cols),
          static_cast<std::uint16_t>(picture.rows), kTypeDimensions, &parts.types, &classes,
          &parts.contours, &parts.scores, &no_surfaces, &views, &parts.key_contours, &no_map),
      fb::ClassIndexIdentifier());
  sign({builder.GetBufferPointer(), builder.GetSize()});
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(builder.GetBufferPointer()),
             static_cast<std::streamsize>(builder.GetSize()));
}

}  // namespace aspect
