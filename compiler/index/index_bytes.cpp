#include "compiler/index/index_bytes.h"

#include <algorithm>

#include "compiler/index/packing.h"
#include "compiler/scene/scene_extent.h"
#include "runtime/recognition/class_index.h"

namespace aspect {
namespace {

namespace fb = ::aspect::schema;

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
  const SourceFromObject& source = scene.source_from_object;
  const Eigen::Vector3d least = source(extent.least), most = source(extent.most),
                        centre = source(scene.studio.at);
  return {least.x(),
          least.y(),
          least.z(),
          most.x(),
          most.y(),
          most.z(),
          source.scale * extent.diameter,
          centre.x(),
          centre.y(),
          centre.z()};
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

flatbuffers::Offset<fb::Model> write_model(flatbuffers::FlatBufferBuilder& builder,
                                           const IndexContents& contents) {
  const PackedModel& model = contents.model;
  if (model.triangles.empty()) return {};
  const auto vertices = builder.CreateVectorOfStructs(model.vertices);
  const auto triangles = builder.CreateVectorOfStructs(model.triangles);
  const auto paints = builder.CreateVectorOfStructs(model.paints);
  const auto vector = [](const Eigen::Vector3d& v) { return fb::Vector(v.x(), v.y(), v.z()); };
  const SourceFromObject& source = contents.scene.source_from_object;
  const fb::Vector least = vector(source(model.least)), unit = vector(source.scale * model.unit),
                   up = vector(contents.scene.studio.up);
  return fb::CreateModel(builder, &least, &unit, &up, source.scale * model.error, vertices,
                         triangles, paints);
}

// A hundred faces with names of twenty letters take 4 KiB: the classes' surfaces alone have theirs.
flatbuffers::Offset<flatbuffers::Vector<flatbuffers::Offset<fb::SurfaceName>>> write_surface_names(
    flatbuffers::FlatBufferBuilder& builder, const Scene& scene,
    std::vector<std::uint16_t> surfaces) {
  std::sort(surfaces.begin(), surfaces.end());
  surfaces.erase(std::unique(surfaces.begin(), surfaces.end()), surfaces.end());
  std::vector<flatbuffers::Offset<fb::SurfaceName>> names;
  for (const std::uint16_t surface : surfaces) {
    if (surface == 0 || surface > scene.names.size()) continue;
    const std::string& name = scene.names[surface - 1U];
    if (name.empty()) continue;
    names.push_back(fb::CreateSurfaceName(builder, surface, builder.CreateString(name)));
  }
  if (names.empty()) return {};
  return builder.CreateVector(names);
}

void set_checksum(std::vector<std::uint8_t>& bytes) {
  auto* table = flatbuffers::GetMutableRoot<flatbuffers::Table>(bytes.data());
  const auto offset =
      static_cast<std::size_t>(table->GetAddressOf(fb::ClassIndex::VT_CHECKSUM) - bytes.data());
  const std::uint64_t checksum = index_checksum(std::as_bytes(std::span(bytes)), offset);
  table->SetField(fb::ClassIndex::VT_CHECKSUM, checksum, std::uint64_t{0});
}

}  // namespace

std::vector<std::uint8_t> index_bytes(const IndexContents& contents, const IndexArrays& arrays,
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
  const Calibration usual;
  const fb::Calibration calibration(usual.slope, usual.even);
  const auto root = fb::CreateClassIndex(
      builder, kIndexFormatVersion, 0, builder.CreateString(contents.scene.name), provenance,
      segmentation, static_cast<fb::Scoring>(options.scoring), static_cast<float>(studio.angle_deg),
      static_cast<std::uint16_t>(studio.width_px), static_cast<std::uint16_t>(studio.height_px),
      static_cast<std::uint16_t>(kTypeDimensions), builder.CreateVector(types),
      builder.CreateVectorOfStructs(arrays.classes), builder.CreateVectorOfStructs(arrays.contours),
      builder.CreateVectorOfStructs(arrays.scores), builder.CreateVector(arrays.surfaces),
      builder.CreateVectorOfStructs(arrays.key_views),
      builder.CreateVectorOfStructs(arrays.key_contours), builder.CreateVector(map),
      builder.CreateVectorOfStructs(packed_rotations(contents.symmetries)),
      builder.CreateVectorOfStructs(packed_axes(contents.symmetries)), &extent,
      write_golden_frame(builder, golden), write_model(builder, contents), &calibration,
      write_surface_names(builder, contents.scene, arrays.surfaces));
  fb::FinishClassIndexBuffer(builder, root);
  std::vector<std::uint8_t> bytes(builder.GetBufferPointer(),
                                  builder.GetBufferPointer() + builder.GetSize());
  set_checksum(bytes);
  return bytes;
}

void set_calibration(std::vector<std::uint8_t>& bytes, const Calibration& calibration) {
  auto* table = flatbuffers::GetMutableRoot<flatbuffers::Table>(bytes.data());
  auto* place = table->GetStruct<fb::Calibration*>(fb::ClassIndex::VT_CALIBRATION);
  *place = fb::Calibration(calibration.slope, calibration.even);
  set_checksum(bytes);
}

}  // namespace aspect
