// The colours of surfaces: ambient light, and point lights with shadows where the scene has any.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "compiler/render/embree_scene.h"
#include "compiler/scene/scene.h"

namespace aspect {

using Rgb = std::array<std::uint8_t, 3>;

// round(255 * colour), colours beyond 0..1 cut off.
Rgb to_8_bit(const Eigen::Vector3d& color);

// The hits of one packet of rays; primitive -1 where a ray hits nothing.
struct PacketHits {
  std::array<std::int32_t, 16> primitive{};
  std::array<std::uint32_t, 16> triangle{};  // of a mesh
  std::array<Eigen::Vector3d, 16> point_object;
};

class Shading {
 public:
  explicit Shading(const Scene& scene);

  bool has_lights() const { return !lights_.empty(); }

  // A primitive's colour where no light is: studio.ambient * surface.ambient.
  const Rgb& ambient(std::int32_t primitive) const {
    return ambient_[static_cast<std::size_t>(primitive)];
  }

  // Colours of points in a camera's sight; those of lanes without a hit stay as they are.
  // Ambient light plus, for every light that reaches the side the camera sees,
  // surface.diffuse * light.color * |normal . direction to the light|.
  void shade(const EmbreeScene& scene, const Eigen::Vector3d& camera_object, const PacketHits& hits,
             std::array<Rgb, 16>& colors) const;

 private:
  struct Material {
    Eigen::Vector3d ambient;  // reflected, the studio's light included
    Eigen::Vector3d diffuse;
  };

  void add_light(const Light& light, const EmbreeScene& scene, const PacketHits& hits,
                 const std::array<Eigen::Vector3d, 16>& normals,
                 std::array<Eigen::Vector3d, 16>& sums) const;
  Eigen::Vector3d normal_at(const PacketHits& hits, std::size_t lane) const;

  std::vector<Primitive> shapes_;  // empty where no light needs them
  std::vector<Light> lights_;
  std::vector<Material> materials_;             // by primitive
  std::vector<Rgb> ambient_;                    // by primitive
  std::vector<Eigen::Vector3d> plate_normals_;  // by primitive; of polygons
};

}  // namespace aspect
