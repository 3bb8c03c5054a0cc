#include "compiler/render/tile_tracer.h"

#include <limits>

namespace aspect {
namespace {

constexpr int kTile = TileMap::kTile;
constexpr int kLanes = kTile * kTile;
static_assert(kLanes == 16);

int column(int lane) {
  return lane % kTile;
}
int row(int lane) {
  return lane / kTile;
}

}  // namespace

TileTracer::TileTracer(const EmbreeScene& scene, const Shading& shading, const Rgb& background,
                       const Camera& camera)
    : scene_(scene),
      shading_(shading),
      background_(background),
      camera_(camera),
      orthogonal_(camera.intrinsics.projection == Projection::kOrthogonal) {
  const Intrinsics& in = camera.intrinsics;
  right_object_ = camera.camera_from_object.row(0).transpose() / in.fx_px;
  down_object_ = camera.camera_from_object.row(1).transpose() / in.fy_px;
  const Eigen::Vector3d forward_object = camera.camera_from_object.row(2).transpose();
  const Eigen::Vector3d centre_object = orthogonal_ ? camera.position_object : forward_object;
  first_object_ = centre_object - in.cx_px * right_object_ - in.cy_px * down_object_;
  for (int lane = 0; lane < kLanes; ++lane) {
    const auto k = static_cast<std::size_t>(lane);
    const Eigen::Vector3d offset = column(lane) * right_object_ + row(lane) * down_object_;
    for (std::size_t axis = 0; axis < 3; ++axis)
      offsets_[axis][k] = static_cast<float>(offset[static_cast<Eigen::Index>(axis)]);
    const Eigen::Vector3d& fixed = orthogonal_ ? forward_object : camera.position_object;
    auto& ray = packet_.ray;
    (orthogonal_ ? ray.dir_x : ray.org_x)[k] = static_cast<float>(fixed.x());
    (orthogonal_ ? ray.dir_y : ray.org_y)[k] = static_cast<float>(fixed.y());
    (orthogonal_ ? ray.dir_z : ray.org_z)[k] = static_cast<float>(fixed.z());
    packet_.ray.mask[k] = ~0u;
  }
}

void TileTracer::aim(const Box& tile) {
  const Eigen::Vector3f corner =
      (first_object_ + tile.x * right_object_ + tile.y * down_object_).cast<float>();
  float* x = orthogonal_ ? packet_.ray.org_x : packet_.ray.dir_x;
  float* y = orthogonal_ ? packet_.ray.org_y : packet_.ray.dir_y;
  float* z = orthogonal_ ? packet_.ray.org_z : packet_.ray.dir_z;
  for (std::size_t k = 0; k < kLanes; ++k) {
    x[k] = corner[0] + offsets_[0][k];
    y[k] = corner[1] + offsets_[1][k];
    z[k] = corner[2] + offsets_[2][k];
    packet_.ray.tfar[k] = std::numeric_limits<float>::infinity();
    packet_.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
  }
}

// Directions have depth 1, so that the length of a ray is the depth of its hit.
void TileTracer::trace(const Box& tile, PixelWriter& writer) {
  alignas(64) std::array<int, kLanes> valid;
  for (int lane = 0; lane < kLanes; ++lane)
    valid[static_cast<std::size_t>(lane)] =
        column(lane) < tile.width && row(lane) < tile.height ? -1 : 0;
  aim(tile);
  scene_.intersect(valid.data(), packet_);

  PacketHits hits;
  std::array<Rgb, kLanes> colors;
  for (std::size_t k = 0; k < kLanes; ++k) {
    const bool hit = packet_.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
    hits.primitive[k] =
        hit ? scene_.primitive_of(packet_.hit.geomID[k], packet_.hit.primID[k]) : -1;
    colors[k] = hit ? shading_.ambient(hits.primitive[k]) : background_;
  }
  if (shading_.has_lights()) shade(tile, hits, colors);
  for (int lane = 0; lane < kLanes; ++lane) {
    const auto k = static_cast<std::size_t>(lane);
    if (valid[k] != 0)
      writer.put(tile.x + column(lane), tile.y + row(lane),
                 static_cast<std::uint16_t>(hits.primitive[k] + 1), colors[k], packet_.ray.tfar[k]);
  }
}

void TileTracer::shade(const Box& tile, PacketHits& hits, std::array<Rgb, 16>& colors) {
  for (int lane = 0; lane < kLanes; ++lane) {
    const auto k = static_cast<std::size_t>(lane);
    const Eigen::Vector3d direction = first_object_ + (tile.x + column(lane)) * right_object_ +
                                      (tile.y + row(lane)) * down_object_;
    if (hits.primitive[k] >= 0)
      hits.triangle[k] = scene_.triangle_of(packet_.hit.geomID[k], packet_.hit.primID[k]);
    hits.point_object[k] = camera_.position_object + double{packet_.ray.tfar[k]} * direction;
  }
  shading_.shade(scene_, camera_.position_object, hits, colors);
}

}  // namespace aspect
