// Single rays and smooth triangles: the part of EmbreeScene that only some scenes need.
#include <limits>

#include "compiler/render/embree_scene.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

void aim(const Vector3d& origin, const Vector3d& direction, double reach, RTCRay& ray) {
  ray.org_x = static_cast<float>(origin.x());
  ray.org_y = static_cast<float>(origin.y());
  ray.org_z = static_cast<float>(origin.z());
  ray.dir_x = static_cast<float>(direction.x());
  ray.dir_y = static_cast<float>(direction.y());
  ray.dir_z = static_cast<float>(direction.z());
  ray.tnear = 0;
  ray.tfar = static_cast<float>(reach);
  ray.mask = ~0u;
}

}  // namespace

void EmbreeScene::add_smooth_triangles(const Scene& scene) {
  std::vector<float> coordinates;
  const auto first_part = static_cast<std::uint32_t>(primitives_.size());
  for (std::size_t k = 0; k < scene.primitives.size(); ++k) {
    const auto* triangle = std::get_if<SmoothTriangle>(&scene.primitives[k].shape);
    if (triangle == nullptr) continue;
    for (const Vector3d& vertex : triangle->vertices)
      for (const double coordinate : vertex) coordinates.push_back(static_cast<float>(coordinate));
    primitives_.push_back(static_cast<std::int32_t>(k));
  }
  const std::size_t corners = coordinates.size() / 3;
  if (corners == 0) return;

  RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* vertex_buffer = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                3 * sizeof(float), corners);
  void* index_buffer = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                               3 * sizeof(std::uint32_t), corners / 3);
  if (vertex_buffer != nullptr && index_buffer != nullptr) {
    std::copy(coordinates.begin(), coordinates.end(), static_cast<float*>(vertex_buffer));
    for (std::uint32_t k = 0; k < corners; ++k) static_cast<std::uint32_t*>(index_buffer)[k] = k;
  }
  first_part_.push_back(first_part);
  add(mesh);
}

std::optional<EmbreeScene::Hit> EmbreeScene::first_hit(const Vector3d& origin,
                                                       const Vector3d& direction,
                                                       double reach) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  aim(origin, direction, reach, query.ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const Vector3d normal(double{query.hit.Ng_x}, double{query.hit.Ng_y}, double{query.hit.Ng_z});
  return Hit{primitive_of(query.hit.geomID, query.hit.primID), double{query.ray.tfar}, normal};
}

bool EmbreeScene::is_blocked(const Vector3d& origin, const Vector3d& direction,
                             double reach) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray{};
  aim(origin, direction, reach, ray);
  rtcOccluded1(scene_, &context, &ray);
  return ray.tfar < 0;
}

}  // namespace aspect
