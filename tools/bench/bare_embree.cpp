#include "tools/bench/bare_embree.h"

#include <algorithm>
#include <limits>

#include "compiler/scene/ear_clipping.h"

namespace aspect {
namespace {

constexpr double kOverlap = 1e-6;  // of round shapes, as the renderer has it

// Directions of depth 1, as the renderer's are.
struct PacketAim {
  Eigen::Vector3d right_object, down_object, first_object;
  std::array<Eigen::Vector3f, 16> offsets;

  explicit PacketAim(const Camera& camera) {
    const Intrinsics& in = camera.intrinsics;
    right_object = camera.camera_from_object.row(0).transpose() / in.fx_px;
    down_object = camera.camera_from_object.row(1).transpose() / in.fy_px;
    first_object = camera.camera_from_object.row(2).transpose();
    first_object -= in.cx_px * right_object + in.cy_px * down_object;
    for (std::size_t k = 0; k < 16; ++k)
      offsets[k] =
          (static_cast<double>(k % 4) * right_object + static_cast<double>(k / 4) * down_object)
              .cast<float>();
  }
  Eigen::Vector3f corner(const Box& tile) const {
    return (first_object + tile.x * right_object + tile.y * down_object).cast<float>();
  }
};

}  // namespace

BareEmbree::BareEmbree(const Scene& scene, bool robust)
    : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
  rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
  rtcSetSceneFlags(scene_, robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
  add_triangles(scene);
  add_round_shapes<Sphere>(scene, spheres_);
  add_round_shapes<Ring>(scene, rings_);
  add_round_shapes<Cone>(scene, cones_);
  rtcCommitScene(scene_);
}

BareEmbree::~BareEmbree() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

void BareEmbree::add_triangles(const Scene& scene) {
  std::vector<float> coordinates;
  std::vector<std::uint32_t> indices;
  const auto take = [&](const std::vector<Eigen::Vector3d>& vertices,
                        const std::vector<Triangle>& triangles) {
    const auto first = static_cast<std::uint32_t>(coordinates.size() / 3);
    for (const Eigen::Vector3d& vertex : vertices)
      for (const double coordinate : vertex) coordinates.push_back(static_cast<float>(coordinate));
    for (const Triangle& triangle : triangles)
      for (const std::uint32_t corner : triangle) indices.push_back(first + corner);
  };
  for (const Primitive& primitive : scene.primitives) {
    if (const auto* polygon = std::get_if<Polygon>(&primitive.shape))
      take(polygon->vertices, triangulate(polygon->vertices));
    if (const auto* mesh = std::get_if<Mesh>(&primitive.shape))
      take(mesh->vertices, mesh->triangles);
  }
  if (indices.empty()) return;
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertex_buffer = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              3 * sizeof(float), coordinates.size() / 3));
  auto* index_buffer = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), indices.size() / 3));
  std::copy(coordinates.begin(), coordinates.end(), vertex_buffer);
  std::copy(indices.begin(), indices.end(), index_buffer);
  add(geometry);
}

template <typename Shape, typename Rounded>
void BareEmbree::add_round_shapes(const Scene& scene, std::vector<Rounded>& shapes) {
  for (const Primitive& primitive : scene.primitives)
    if (const auto* shape = std::get_if<Shape>(&primitive.shape))
      shapes.push_back(rounded(*shape, kOverlap));
  if (shapes.empty()) return;
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
  set_shapes(geometry, shapes.data(), static_cast<unsigned>(shapes.size()));
  add(geometry);
}

void BareEmbree::add(RTCGeometry geometry) {
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
}

void BareEmbree::trace(const Camera& camera, std::span<const Box> tiles,
                       std::vector<std::uint32_t>& ids) {
  const PacketAim aim(camera);
  const Eigen::Vector3f origin = camera.position_object.cast<float>();
  RTCRayHit16 packet{};
  std::fill_n(packet.ray.org_x, 16, origin.x());
  std::fill_n(packet.ray.org_y, 16, origin.y());
  std::fill_n(packet.ray.org_z, 16, origin.z());
  std::fill_n(packet.ray.mask, 16, ~0u);
  alignas(64) std::array<int, 16> valid;
  valid.fill(-1);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  ids.resize(16 * tiles.size());
  std::uint32_t* next = ids.data();
  for (const Box& tile : tiles) {
    const Eigen::Vector3f corner = aim.corner(tile);
    for (std::size_t k = 0; k < 16; ++k) {
      packet.ray.dir_x[k] = corner.x() + aim.offsets[k].x();
      packet.ray.dir_y[k] = corner.y() + aim.offsets[k].y();
      packet.ray.dir_z[k] = corner.z() + aim.offsets[k].z();
      packet.ray.tfar[k] = std::numeric_limits<float>::infinity();
      packet.hit.geomID[k] = packet.hit.primID[k] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect16(valid.data(), scene_, &context, &packet);
    next = std::copy_n(packet.hit.primID, 16, next);
  }
}

}  // namespace aspect
