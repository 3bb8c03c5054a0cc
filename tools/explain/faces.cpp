#include "tools/explain/faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace aspect {
namespace {

struct Plane {
  Eigen::Vector3d normal{0, 0, 0};
  double offset = 0;
};

// Newell's normal, its sign chosen so that both windings agree.
Plane plane_of(const Polygon& polygon) {
  Plane plane;
  const auto& v = polygon.vertices;
  for (std::size_t k = 0; k < v.size(); ++k) plane.normal += v[k].cross(v[(k + 1) % v.size()]);
  plane.normal.normalize();
  Eigen::Index axis = 0;
  plane.normal.cwiseAbs().maxCoeff(&axis);
  if (plane.normal[axis] < 0) plane.normal = -plane.normal;
  plane.offset = plane.normal.dot(v.front());
  return plane;
}

bool is_same(const Plane& a, const Plane& b) {
  return (a.normal - b.normal).norm() < 1e-3 && std::abs(a.offset - b.offset) < 1e-4;
}

}  // namespace

Faces faces_of(const Scene& scene) {
  Faces faces;
  faces.face_of.assign(scene.primitives.size() + 1, 0);
  std::vector<std::pair<Plane, std::size_t>> planes;
  for (std::size_t k = 0; k < scene.primitives.size(); ++k) {
    const Primitive& primitive = scene.primitives[k];
    const Surface& surface = scene.surfaces[static_cast<std::size_t>(primitive.surface)];
    const Eigen::Vector3d colour = colour_seen(scene, surface);
    std::size_t face = faces.all.size();
    if (const auto* polygon = std::get_if<Polygon>(&primitive.shape)) {
      const Plane plane = plane_of(*polygon);
      const auto known = std::find_if(planes.begin(), planes.end(), [&](const auto& other) {
        return is_same(plane, other.first) &&
               (faces.all[other.second].colour - colour).norm() < 1e-6;
      });
      if (known != planes.end())
        face = known->second;
      else
        planes.emplace_back(plane, face);
    }
    if (face == faces.all.size()) faces.all.push_back({{}, colour});
    faces.all[face].primitives.push_back(static_cast<std::uint16_t>(k + 1));
    if (faces.all[face].name.empty() && k < scene.names.size())
      faces.all[face].name = scene.names[k];
    faces.face_of[k + 1] = face;
  }
  return faces;
}

void paint(Scene& scene, const Face& face, const Eigen::Vector3d& colour) {
  for (const std::uint16_t id : face.primitives) {
    Primitive& primitive = scene.primitives[id - 1U];
    Surface surface = scene.surfaces[static_cast<std::size_t>(primitive.surface)];
    const Eigen::Vector3d light =
        scene.lights.empty() ? scene.studio.ambient : Eigen::Vector3d(1, 1, 1);
    surface.diffuse = surface.ambient = colour.cwiseQuotient(light.cwiseMax(0.05)).cwiseMin(1.0);
    primitive.surface = static_cast<int>(scene.surfaces.size());
    scene.surfaces.push_back(surface);
  }
}

}  // namespace aspect
