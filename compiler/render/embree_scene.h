// A scene in Embree's hands: built once, traced by any number of threads.
#pragma once

#include <embree3/rtcore.h>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "compiler/render/round_shapes.h"
#include "compiler/scene/ear_clipping.h"
#include "compiler/scene/scene.h"
#include "runtime/base/result.h"

namespace aspect {

class EmbreeScene {
 public:
  // `triangles` holds those of every polygon by primitive; meshes bring their own. Fails with
  // Embree's own words.
  static Result<EmbreeScene> create(const Scene& scene,
                                    std::span<const std::vector<Triangle>> triangles);

  EmbreeScene(EmbreeScene&& other) noexcept;
  EmbreeScene& operator=(EmbreeScene&& other) noexcept;
  ~EmbreeScene();

  // Both take the lanes whose `valid` is -1; the rays of a packet should be neighbours.
  void intersect(const int* valid, RTCRayHit16& packet) const;
  void occlude(const int* valid, RTCRay16& packet) const;

  struct Hit {
    std::int32_t primitive = 0;
    double distance = 0;           // in lengths of the direction
    Eigen::Vector3d plane_normal;  // of flat shapes, any length, either side
  };
  // One ray, from its origin on to origin + reach * direction.
  std::optional<Hit> first_hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                               double reach = std::numeric_limits<double>::infinity()) const;
  bool is_blocked(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                  double reach) const;

  // The scene's primitive behind a hit's two ids.
  std::int32_t primitive_of(unsigned geometry, unsigned part) const {
    return primitives_[first_part_[geometry] + part];
  }
  // The mesh's triangle behind a hit's two ids, where the primitive is a mesh.
  std::uint32_t triangle_of(unsigned geometry, unsigned part) const {
    const std::uint32_t k = first_part_[geometry] + part;
    return k - first_triangle_[static_cast<std::size_t>(primitives_[k])];
  }

 private:
  EmbreeScene() = default;
  void add_triangles(const Scene& scene, std::span<const std::vector<Triangle>> triangles);
  void add_smooth_triangles(const Scene& scene);
  template <typename Shape, typename Rounded>
  void add_round_shapes(const Scene& scene, double overlap, std::vector<Rounded>& shapes);
  void add(RTCGeometry geometry);

  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  std::vector<RoundSphere> spheres_;
  std::vector<RoundRing> rings_;
  std::vector<RoundCone> cones_;
  std::vector<std::int32_t> primitives_;       // by part, the parts of geometry 0 first
  std::vector<std::uint32_t> first_part_;      // by geometry
  std::vector<std::uint32_t> first_triangle_;  // by primitive: the first of its parts
};

}  // namespace aspect
