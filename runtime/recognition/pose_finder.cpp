#include "runtime/recognition/pose_finder.h"

#include <algorithm>
#include <cmath>

namespace aspect {
namespace {

// Cells of a drawing that is only compared coarsely.
constexpr int kCoarseCells = 24;

Vector3d doubles(const Vector3& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

// What a drawing covers with colours that can be seen.
struct DrawnArea {
  float area_px = 0;
  Point2d centre_px;
};

DrawnArea drawn_area(const ModelDrawing& drawing, const Box& looked_at) {
  const auto left = static_cast<float>(looked_at.x), top = static_cast<float>(looked_at.y),
             right = left + static_cast<float>(looked_at.width),
             bottom = top + static_cast<float>(looked_at.height);
  DrawnArea drawn;
  int count = 0;
  double x = 0, y = 0;
  for (int row = 0; row < drawing.height(); ++row)
    for (int column = 0; column < drawing.width(); ++column) {
      const float cell_x = drawing.x_px(column), cell_y = drawing.y_px(row);
      if (drawing.cell(column, row).colour == kBackgroundClass || cell_x < left ||
          cell_x >= right || cell_y < top || cell_y >= bottom)
        continue;
      ++count;
      x += static_cast<double>(cell_x);
      y += static_cast<double>(cell_y);
    }
  drawn.area_px = static_cast<float>(count) * drawing.cell_px() * drawing.cell_px();
  if (count > 0) drawn.centre_px = {x / count, y / count};
  return drawn;
}

}  // namespace

void PoseFinder::prepare(Arena& arena, std::span<const ClassIndex> indexes) {
  std::size_t vertices = 0;
  for (const ClassIndex& index : indexes)
    vertices = std::max(vertices, index.model.vertices.size());
  scratch_.drawing.prepare(arena, vertices);
}

RigidPose PoseFinder::start(const ClassIndex& index, const ViewStart& view,
                            const CameraModel& camera, const Blob& blob, const Box& looked_at,
                            int corrections) {
  const ObjectModel& model = index.model;
  const Point2d centre = camera.straight(
      {static_cast<double>(blob.centre_px.x), static_cast<double>(blob.centre_px.y)});
  Vector3d ray{(centre.x - camera.cx_px) / camera.fx_px, (centre.y - camera.cy_px) / camera.fy_px,
               1};
  const Vector3d key = doubles(view.key_direction);
  const Rotation straight_ahead = turn_about({0, 0, 1}, static_cast<double>(view.roll_rad)) *
                                  camera_from_object(key, model.up) *
                                  turn_between(doubles(view.direction), key);
  RigidPose pose;
  pose.rotation = turn_between({0, 0, 1}, (1 / norm(ray)) * ray) * straight_ahead;
  const auto side_px = std::sqrt(static_cast<double>(std::max(1.0F, blob.area_px)));
  double depth = camera.fx_px * model.radius * 1.3 / side_px;
  for (int round = 0;; ++round) {
    pose.translation = depth * ray - pose.rotation(model.centre);
    if (round == corrections || !scratch_.drawing.draw(model, pose, camera, blob.box, kCoarseCells))
      return pose;
    const DrawnArea drawn = drawn_area(scratch_.drawing, looked_at);
    if (drawn.area_px <= 0) return pose;
    depth *= std::clamp(std::sqrt(static_cast<double>(drawn.area_px / blob.area_px)), 0.5, 2.0);
    ray = ray + Vector3d{(centre.x - drawn.centre_px.x) / camera.fx_px,
                         (centre.y - drawn.centre_px.y) / camera.fy_px, 0};
  }
}

VerifiedPose PoseFinder::verify(const ClassIndex& index, const RigidPose& start,
                                const LightGain& light, const CameraModel& camera,
                                const RegionMap& regions, const Planes& colours, int blob,
                                int rounds) {
  const ObjectModel& model = index.model;
  const Box& box = regions.blobs[static_cast<std::size_t>(blob)].box;
  seen_.look(regions, colours, blob, model, light);
  VerifiedPose verified;
  verified.refined.pose = start;
  if (rounds > 0) {
    constexpr float kLeastReach_px = 5, kReach = 0.07F;
    const float reach_px =
        std::max(kLeastReach_px, kReach * static_cast<float>(std::max(box.width, box.height)));
    verified.refined = refine_pose(model, camera, seen_, box, start, rounds, reach_px, scratch_);
  } else if (!scratch_.drawing.draw(model, start, camera, box, kCoarseCells)) {
    return verified;
  }
  verified.agreement = agreement(scratch_.drawing, camera, seen_);
  return verified;
}

}  // namespace aspect
