#include "compiler/index/index_writer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/index/golden_choice.h"
#include "compiler/index/sphere_map.h"
#include "compiler/scene/scene_extent.h"
#include "runtime/recognition/class_index.h"
#include "schema/class_index_generated.h"

namespace aspect {
namespace {

namespace fb = ::aspect::schema;

// Closer key views than this do not make the answer better: measured in tools/bench/RESULTS.md.
constexpr double kFinestSpacing_deg = 5, kCoarsestSpacing_deg = 60, kSpacingStep = 1.15;
constexpr std::size_t kMostMapBytes = 16 * 1024;

template <typename Integer>
Integer packed(double value, double unit) {
  constexpr auto kLow = static_cast<double>(std::numeric_limits<Integer>::min());
  constexpr auto kHigh = static_cast<double>(std::numeric_limits<Integer>::max());
  return static_cast<Integer>(std::lround(std::clamp(value * unit, kLow, kHigh)));
}
std::int16_t packed_short(float value, double unit) {
  return packed<std::int16_t>(static_cast<double>(value), unit);
}

fb::Direction packed_direction(const Eigen::Vector3d& d) {
  return {packed<std::int16_t>(d.x(), 32767), packed<std::int16_t>(d.y(), 32767),
          packed<std::int16_t>(d.z(), 32767)};
}

fb::KeyContour packed_contour(const ContourFeature& f, std::uint8_t name) {
  const Moments& m = f.moments;
  return {packed_short(f.position.x, 8192),
          packed_short(f.position.y, 8192),
          packed<std::uint16_t>(static_cast<double>(f.area), 65535),
          packed_short(m.xx, 4096),
          packed_short(m.xy, 4096),
          packed_short(m.yy, 4096),
          packed_short(m.xxx, 16384),
          packed_short(m.xxy, 16384),
          packed_short(m.xyy, 16384),
          packed_short(m.yyy, 16384),
          name};
}

struct Arrays {
  std::vector<fb::AspectClass> classes;
  std::vector<fb::ClassContour> contours;
  std::vector<fb::TypeScore> scores;
  std::vector<std::uint16_t> surfaces;
  std::vector<fb::KeyView> key_views;
  std::vector<fb::KeyContour> key_contours;
};

void add_contour(const ContourDescription& c, Arrays& arrays) {
  const auto share = [&](std::size_t channel) {
    return packed<std::uint8_t>(c.share[channel], 255);
  };
  // 16-bit places and an 8-bit count: what is beyond them is left out.
  std::size_t surface_count = std::min<std::size_t>(c.surfaces.size(), 255);
  if (arrays.surfaces.size() + surface_count > 65535) surface_count = 0;
  arrays.contours.emplace_back(
      static_cast<std::uint32_t>(arrays.scores.size()),
      static_cast<std::uint16_t>(c.score_of_type.size()),
      static_cast<std::uint16_t>(surface_count > 0 ? arrays.surfaces.size() : 0),
      static_cast<std::uint8_t>(surface_count), share(0), share(1), share(2),
      static_cast<float>(c.centre_object.x()), static_cast<float>(c.centre_object.y()),
      static_cast<float>(c.centre_object.z()));
  for (const auto& [type, score] : c.score_of_type)
    arrays.scores.emplace_back(static_cast<float>(score), type, std::uint16_t{0});
  arrays.surfaces.insert(arrays.surfaces.end(), c.surfaces.begin(),
                         c.surfaces.begin() + static_cast<std::ptrdiff_t>(surface_count));
}

Arrays fill_arrays(const IndexContents& contents, std::size_t class_count, double spacing_deg) {
  Arrays arrays;
  for (std::size_t c = 0; c < class_count; ++c) {
    const Cluster& cluster = contents.clusters[c];
    const ClassDescription& description = contents.classes[c];
    const std::vector<std::size_t> keys =
        choose_key_views(contents.subdivision, cluster, description.typical_view,
                         spacing_deg * std::numbers::pi / 180);
    const Eigen::Vector3d& typical =
        contents.subdivision.direction(cluster.views[description.typical_view].vertex);
    arrays.classes.emplace_back(
        static_cast<std::uint32_t>(arrays.contours.size()),
        static_cast<std::uint32_t>(cluster.contour_count),
        static_cast<std::uint32_t>(arrays.key_views.size()),
        static_cast<std::uint32_t>(keys.size()), static_cast<float>(cluster.area_fraction),
        static_cast<std::uint32_t>(description.view_count), packed_direction(typical));
    for (const ContourDescription& contour : description.contours) add_contour(contour, arrays);
    for (const std::size_t key : keys) {
      const ClusterView& view = cluster.views[key];
      const ObservedView& observed = contents.subdivision.views[number(view.vertex)];
      arrays.key_views.emplace_back(static_cast<std::uint32_t>(arrays.key_contours.size()),
                                    static_cast<std::uint16_t>(cluster.contour_count),
                                    packed_direction(observed.direction));
      for (std::size_t i = 0; i < cluster.contour_count; ++i)
        arrays.key_contours.push_back(packed_contour(observed.contours[i].feature, view.names[i]));
    }
  }
  return arrays;
}

std::vector<std::uint8_t> map_of(const IndexContents& contents, std::size_t class_count) {
  return encode_sphere_map_within(contents.subdivision.sphere, contents.sphere_classes, class_count,
                                  std::min(kMostMapBytes, contents.options.max_index_bytes / 4));
}

// Colour indexes are as they were before there were other sensors.
flatbuffers::Offset<fb::Segmentation> write_segmentation(flatbuffers::FlatBufferBuilder& builder,
                                                         const VisionParameters& v) {
  fb::SegmentationBuilder table(builder);
  if (v.sensor == SensorKind::range) {
    table.add_range_normal_step_deg(v.range.normal_step_deg);
    table.add_range_depth_step(v.range.depth_step);
    table.add_range_step_length(v.range.step_length);
    table.add_range_steps_max(static_cast<std::uint16_t>(v.range.steps_max));
    table.add_range_steps_min(static_cast<std::uint16_t>(v.range.steps_min));
  }
  table.add_thickness_min_px(v.thickness_min_px);
  table.add_area_min_px(static_cast<std::uint32_t>(v.area_min_px));
  table.add_intensity_step(static_cast<std::uint16_t>(v.intensity_step));
  table.add_intensity_min(static_cast<std::uint16_t>(v.intensity_min));
  if (v.sensor != SensorKind::colour) table.add_sensor(static_cast<fb::Sensor>(v.sensor));
  table.add_smooth(v.smooth);
  table.add_noise_steps(static_cast<std::uint8_t>(v.noise_steps));
  table.add_chroma_step(static_cast<std::uint8_t>(v.chroma_step));
  return table.Finish();
}

std::vector<fb::Rotation> packed_rotations(const Symmetries& symmetries) {
  std::vector<fb::Rotation> packed;
  for (const Eigen::Quaterniond& q : symmetries.rotations) {
    const Eigen::Quaternionf f = q.cast<float>();
    packed.emplace_back(f.w(), f.x(), f.y(), f.z());
  }
  return packed;
}

std::vector<fb::Axis> packed_axes(const Symmetries& symmetries) {
  std::vector<fb::Axis> packed;
  for (const Eigen::Vector3d& axis : symmetries.axes) {
    const Eigen::Vector3f f = axis.cast<float>();
    packed.emplace_back(f.x(), f.y(), f.z());
  }
  return packed;
}

fb::Extent packed_extent(const Scene& scene) {
  const SceneExtent extent = scene_extent(scene);
  const Eigen::Vector3d &least = extent.least, &most = extent.most, &centre = scene.studio.at;
  return {least.x(), least.y(),       least.z(),  most.x(),   most.y(),
          most.z(),  extent.diameter, centre.x(), centre.y(), centre.z()};
}

flatbuffers::Offset<fb::GoldenFrame> write_golden_frame(flatbuffers::FlatBufferBuilder& builder,
                                                        const std::optional<GoldenFrame>& golden) {
  if (!golden) return {};
  const auto palette = builder.CreateVector(golden->palette);
  const auto rows = builder.CreateVector(golden->rows);
  return fb::CreateGoldenFrame(
      builder, static_cast<std::uint16_t>(golden->width_px),
      static_cast<std::uint16_t>(golden->height_px), palette, rows, golden->class_id,
      packed<std::uint16_t>(static_cast<double>(golden->score), 65535),
      static_cast<std::uint8_t>(golden->regions), static_cast<std::uint8_t>(golden->matched));
}

std::vector<std::uint8_t> serialise(const IndexContents& contents, const Arrays& arrays,
                                    const std::vector<std::uint8_t>& map,
                                    const std::optional<GoldenFrame>& golden) {
  const CompileOptions& options = contents.options;
  const VisionParameters& v = options.vision;
  flatbuffers::FlatBufferBuilder builder(64 * 1024);
  builder.ForceDefaults(true);
  const auto provenance = fb::CreateProvenance(
      builder, builder.CreateString("aspectc"), contents.scene_hash,
      static_cast<std::uint8_t>(options.level), static_cast<std::uint8_t>(options.min_level),
      options.threshold, options.cluster_threshold);
  const auto segmentation = write_segmentation(builder, v);
  std::vector<float> types;
  for (const TypeAttributes& type : contents.types)
    types.insert(types.end(), type.begin(), type.end());
  const Studio& studio = contents.scene.studio;
  const fb::Extent extent = packed_extent(contents.scene);
  const auto root = fb::CreateClassIndex(
      builder, index_format_version(v.sensor), 0, builder.CreateString(contents.scene.name),
      provenance, segmentation, static_cast<fb::Scoring>(options.scoring),
      static_cast<float>(studio.angle_deg), static_cast<std::uint16_t>(studio.width_px),
      static_cast<std::uint16_t>(studio.height_px), static_cast<std::uint16_t>(kTypeDimensions),
      builder.CreateVector(types), builder.CreateVectorOfStructs(arrays.classes),
      builder.CreateVectorOfStructs(arrays.contours), builder.CreateVectorOfStructs(arrays.scores),
      builder.CreateVector(arrays.surfaces), builder.CreateVectorOfStructs(arrays.key_views),
      builder.CreateVectorOfStructs(arrays.key_contours), builder.CreateVector(map),
      builder.CreateVectorOfStructs(packed_rotations(contents.symmetries)),
      builder.CreateVectorOfStructs(packed_axes(contents.symmetries)), &extent,
      write_golden_frame(builder, golden));
  fb::FinishClassIndexBuffer(builder, root);
  std::vector<std::uint8_t> bytes(builder.GetBufferPointer(),
                                  builder.GetBufferPointer() + builder.GetSize());
  auto* table = flatbuffers::GetMutableRoot<flatbuffers::Table>(bytes.data());
  const auto offset =
      static_cast<std::size_t>(table->GetAddressOf(fb::ClassIndex::VT_CHECKSUM) - bytes.data());
  const std::uint64_t checksum = index_checksum(std::as_bytes(std::span(bytes)), offset);
  table->SetField(fb::ClassIndex::VT_CHECKSUM, checksum, std::uint64_t{0});
  return bytes;
}

// What an index is made of, once it is known what fits in.
struct Draft {
  Arrays arrays;
  std::vector<std::uint8_t> map;
};

// The most bytes that a candidate takes.
std::size_t golden_reserve(std::span<const GoldenFrame> candidates) {
  std::size_t most = 0;
  for (const GoldenFrame& golden : candidates) most = std::max(most, golden_bytes(golden));
  return most;
}

void add_golden_frame(const IndexContents& contents, const Draft& draft, WrittenIndex& written) {
  if (contents.golden_candidates.empty()) return;
  const Result<ClassIndex> index =
      parse_index(std::as_bytes(std::span(written.bytes)), contents.scene.name);
  if (!index) return;
  const auto golden = choose_golden_frame(index.value(), contents.golden_candidates);
  if (!golden) return;
  const std::size_t bytes_without = written.bytes.size();
  written.bytes = serialise(contents, draft.arrays, draft.map, golden);
  written.golden_frame_bytes = written.bytes.size() - bytes_without;
}

}  // namespace

WrittenIndex write_index(const IndexContents& contents) {
  const std::size_t budget =
      contents.options.max_index_bytes - golden_reserve(contents.golden_candidates);
  WrittenIndex written;
  Draft draft;
  const auto write = [&](std::size_t class_count, double spacing_deg,
                         const std::vector<std::uint8_t>& map) {
    draft = {fill_arrays(contents, class_count, spacing_deg), map};
    written.class_count = class_count;
    written.key_view_count = draft.arrays.key_views.size();
    written.key_view_spacing_deg = spacing_deg;
    written.bytes = serialise(contents, draft.arrays, map, std::nullopt);
    return written.bytes.size() <= budget;
  };
  const std::vector<std::uint8_t> whole_map = map_of(contents, contents.clusters.size());
  double spacing_deg = kFinestSpacing_deg;
  while (!write(contents.clusters.size(), spacing_deg, whole_map) &&
         spacing_deg < kCoarsestSpacing_deg)
    spacing_deg *= kSpacingStep;
  if (written.bytes.size() > budget) {
    // The most classes that fit, at the coarsest spacing.
    std::size_t fits = 0, too_many = contents.clusters.size();
    while (too_many - fits > 1) {
      const std::size_t middle = (fits + too_many) / 2;
      (write(middle, spacing_deg, map_of(contents, middle)) ? fits : too_many) = middle;
    }
    write(fits, spacing_deg, map_of(contents, fits));
  }
  add_golden_frame(contents, draft, written);
  for (const Cluster& cluster : contents.clusters.first(written.class_count)) {
    written.area_fraction += cluster.area_fraction;
    written.area_assigned += cluster.area_assigned;
  }
  return written;
}

}  // namespace aspect
