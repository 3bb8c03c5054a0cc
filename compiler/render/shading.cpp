#include "compiler/render/shading.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "compiler/render/surface_normal.h"
#include "compiler/scene/ear_clipping.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

// A shadow ray starts off the surface by this share of its distance from the camera: ten times the
// error of a hit in single precision.
constexpr double kShadowOffset = 1e-5;

// Of the surface that the shape is a part of, at a point on or near it; either side.
struct NormalAt {
  Vector3d point;
  Vector3d polygon_normal;
  std::uint32_t triangle;

  Vector3d operator()(const Polygon&) const { return polygon_normal; }
  template <typename Shape>
  Vector3d operator()(const Shape& shape) const {
    return aspect::normal_at(shape, point);
  }
  Vector3d operator()(const Mesh& mesh) const {
    const auto& [a, b, c] = mesh.triangles[triangle];
    const Vector3d& corner = mesh.vertices[a];
    return (mesh.vertices[b] - corner).cross(mesh.vertices[c] - corner).normalized();
  }
};

}  // namespace

Rgb to_8_bit(const Vector3d& color) {
  Rgb result{};
  for (Eigen::Index k = 0; k < 3; ++k)
    result[static_cast<std::size_t>(k)] =
        static_cast<std::uint8_t>(std::lround(255 * std::clamp(color[k], 0.0, 1.0)));
  return result;
}

Shading::Shading(const Scene& scene) : lights_(scene.lights) {
  for (const Primitive& primitive : scene.primitives) {
    const Surface& surface = scene.surfaces[static_cast<std::size_t>(primitive.surface)];
    const Vector3d ambient = scene.studio.ambient.cwiseProduct(surface.ambient);
    materials_.push_back({ambient, surface.diffuse});
    ambient_.push_back(to_8_bit(ambient));
  }
  if (lights_.empty()) return;
  shapes_ = scene.primitives;
  for (const Primitive& primitive : shapes_) {
    const auto* polygon = std::get_if<Polygon>(&primitive.shape);
    plate_normals_.push_back(polygon != nullptr ? polygon_normal(polygon->vertices)
                                                : Vector3d::Zero());
  }
}

void Shading::shade(const EmbreeScene& scene, const Vector3d& camera_object, const PacketHits& hits,
                    std::array<Rgb, 16>& colors) const {
  std::array<Vector3d, 16> normals, sums;
  for (std::size_t k = 0; k < 16; ++k) {
    if (hits.primitive[k] < 0) continue;
    const Vector3d to_camera = camera_object - hits.point_object[k];
    const Vector3d normal = normal_at(hits, k);
    normals[k] = normal.dot(to_camera) < 0 ? Vector3d(-normal) : normal;
    sums[k] = materials_[static_cast<std::size_t>(hits.primitive[k])].ambient;
  }
  PacketHits starts = hits;
  for (std::size_t k = 0; k < 16; ++k) {
    if (hits.primitive[k] < 0) continue;
    const double distance = (camera_object - hits.point_object[k]).norm();
    starts.point_object[k] += kShadowOffset * distance * normals[k];
  }
  for (const Light& light : lights_) add_light(light, scene, starts, normals, sums);
  for (std::size_t k = 0; k < 16; ++k)
    if (hits.primitive[k] >= 0) colors[k] = to_8_bit(sums[k]);
}

void Shading::add_light(const Light& light, const EmbreeScene& scene, const PacketHits& hits,
                        const std::array<Vector3d, 16>& normals,
                        std::array<Vector3d, 16>& sums) const {
  alignas(64) std::array<int, 16> valid{};
  RTCRay16 rays{};
  std::array<double, 16> cosines{};
  for (std::size_t k = 0; k < 16; ++k) {
    if (hits.primitive[k] < 0) continue;
    const Vector3d& point = hits.point_object[k];
    const Vector3d to_light = light.position - point;
    cosines[k] = std::max(0.0, normals[k].dot(to_light.normalized()));
    if (cosines[k] == 0 || !light.casts_shadows) continue;
    valid[k] = -1;
    rays.org_x[k] = static_cast<float>(point.x());
    rays.org_y[k] = static_cast<float>(point.y());
    rays.org_z[k] = static_cast<float>(point.z());
    rays.dir_x[k] = static_cast<float>(to_light.x());
    rays.dir_y[k] = static_cast<float>(to_light.y());
    rays.dir_z[k] = static_cast<float>(to_light.z());
    rays.tfar[k] = 1;
    rays.mask[k] = ~0u;
  }
  if (light.casts_shadows) scene.occlude(valid.data(), rays);
  for (std::size_t k = 0; k < 16; ++k) {
    if (cosines[k] == 0 || rays.tfar[k] < 0) continue;
    const Material& material = materials_[static_cast<std::size_t>(hits.primitive[k])];
    sums[k] += cosines[k] * material.diffuse.cwiseProduct(light.color);
  }
}

Vector3d Shading::normal_at(const PacketHits& hits, std::size_t lane) const {
  const auto k = static_cast<std::size_t>(hits.primitive[lane]);
  return std::visit(NormalAt{hits.point_object[lane], plate_normals_[k], hits.triangle[lane]},
                    shapes_[k].shape);
}

}  // namespace aspect
