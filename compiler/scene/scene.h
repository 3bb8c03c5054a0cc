// A coloured CAD model as the compiler sees it: flat lists of primitives in object coordinates,
// all transforms applied. Lengths are in the scene's units (the viewing sphere has radius 1),
// colours are linear r g b in 0..1.
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

namespace aspect {

struct Surface {
  Eigen::Vector3d diffuse{1, 1, 1};
  Eigen::Vector3d ambient{1, 1, 1};  // share of the studio's ambient light that is reflected
};

// Planar, convex or not, either winding, seen from both sides.
struct Polygon {
  std::vector<Eigen::Vector3d> vertices;
};

struct Sphere {
  Eigen::Vector3d center;
  double radius = 0;
};

// A flat annulus; a disc where min_radius is 0.
struct Ring {
  Eigen::Vector3d center;
  Eigen::Vector3d normal;  // unit length
  double min_radius = 0;
  double max_radius = 0;
};

// The curved side of a (truncated) cone or cylinder, open at both ends.
struct Cone {
  Eigen::Vector3d base;
  Eigen::Vector3d apex;
  double base_radius = 0;
  double apex_radius = 0;
};

struct Primitive {
  std::variant<Polygon, Sphere, Ring, Cone> shape;
  int surface = 0;  // index into Scene::surfaces
};

struct PointLight {
  Eigen::Vector3d position;
  Eigen::Vector3d color{1, 1, 1};
  bool casts_shadows = true;
};

// The picture-taking half of a scene: the camera stands on the viewing sphere and looks at `at`.
struct Studio {
  Eigen::Vector3d at{0, 0, 0};
  Eigen::Vector3d up{0, 0, 1};
  double angle_deg = 45;  // full horizontal field of view
  int width_px = 512;
  int height_px = 512;
  double aspect = 1;  // picture width / height
  Eigen::Vector3d ambient{0, 0, 0};
  Eigen::Vector3d background{0, 0, 0};
};

struct Scene {
  std::string name;  // the file's name without folder and extension
  std::string file;  // that it was read from; empty: none
  Studio studio;
  std::vector<Surface> surfaces;
  std::vector<Primitive> primitives;  // a primitive's index + 1 is its surface id in pictures
  std::vector<PointLight> lights;
  std::vector<std::string> warnings;  // one line each, with file and line
  std::string source;  // the preprocessed words, normalised: what a store's key hashes
};

// Smallest radius of a sphere about the origin that holds every primitive (for cones and rings
// the exact one of their rims).
double bounding_radius(const Scene& scene);

}  // namespace aspect
