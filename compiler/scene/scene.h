// A coloured CAD model as the compiler sees it: flat lists of primitives in object coordinates,
// all transforms applied. Lengths are in the scene's units (the viewing sphere has radius 1),
// colours are r g b in 0..1 as displayed: a picture shows 255 * colour (colour_meaning.h).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/scene/missing_colour.h"
#include "compiler/scene/texture.h"

namespace aspect {

// How these add up to a colour: see compiler/render/ray_shading.h.
struct Surface {
  Eigen::Vector3d diffuse{1, 1, 1};
  Eigen::Vector3d ambient{1, 1, 1};      // share of the studio's ambient light that is reflected
  Eigen::Vector3d specular{0, 0, 0};     // share of what a mirror in its place would show
  Eigen::Vector3d transparent{0, 0, 0};  // share of what lies behind that shines through
  double ior = 1;                        // index of refraction of what the surface encloses
  double shine = 0;                      // exponent of the Phong highlight; 0: none
  Eigen::Vector3d shine_color{1, 1, 1};
  double fuzz = 0;        // how far the end of the unit normal strays in mirrors and glass
  bool antialias = true;  // false: pixels that show only such surfaces are not split
  bool casts_shadow = true;
  std::shared_ptr<const Texture> texture = nullptr;  // multiplies diffuse and ambient; null: none
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

// A piece of surface of any form, flat-shaded, either winding, seen from both sides.
struct Mesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // indices of vertices
};

// A flat triangle, seen from both sides, that is shaded as if it were curved: with normals between
// those of its vertices (unit length).
struct SmoothTriangle {
  std::array<Eigen::Vector3d, 3> vertices;
  std::array<Eigen::Vector3d, 3> normals;
};

struct Primitive {
  std::variant<Polygon, Sphere, Ring, Cone, Mesh, SmoothTriangle> shape;
  int surface = 0;  // index into Scene::surfaces
};

// The light that reaches a point at distance d is color / d^falloff.
struct Light {
  enum class Type { kPoint, kDirectional, kSpherical };

  // Full light within the inner cone around the way to `at`, none beyond the outer one, linear in
  // the cosine of the angle between them.
  struct Spot {
    Eigen::Vector3d at{0, 0, 0};
    double min_angle_deg = 0, max_angle_deg = 0;  // full openings
  };

  Eigen::Vector3d position{0, 0, 0};  // but of a directional light
  Eigen::Vector3d color{1, 1, 1};
  bool casts_shadows = true;
  Type type = Type::kPoint;
  Eigen::Vector3d direction{0, 0, -1};  // in which directional light travels; unit length
  double radius = 0;                    // of a spherical light
  int samples = 16;                     // points of a spherical light
  int falloff = 0;                      // 0, 1 or 2
  std::optional<Spot> spot = std::nullopt;
};

// Of a calibrated camera; pixel centres are at whole numbers.
struct Lens {
  double fx_px = 0, fy_px = 0;  // focal lengths
  double cx_px = 0, cy_px = 0;  // principal point
};

enum class Antialias {
  kNone,      // the ray through a pixel's centre
  kQuick,     // the mean of a pixel's corners where a neighbour shows another surface
  kCorners,   // the mean of a pixel's corners everywhere
  kAdaptive,  // corners; where they differ by more than the threshold, a pixel is split into four
};

enum class Projection { kPerspective, kOrthogonal };

// The picture-taking half of a scene: the camera stands on the viewing sphere and looks at `at`.
struct Studio {
  Eigen::Vector3d at{0, 0, 0};
  Eigen::Vector3d up{0, 0, 1};
  double angle_deg = 45;  // full horizontal field of view
  int width_px = 512;
  int height_px = 512;
  double aspect = 1;         // picture width / height
  std::optional<Lens> lens;  // where it is known; angle_deg and aspect are then what it makes them
  double distance = 1;       // of the camera from `at`
  Eigen::Vector3d ambient{0, 0, 0};
  Eigen::Vector3d background{0, 0, 0};
  Projection projection = Projection::kPerspective;
  double width = 0;  // of the picture in an orthogonal projection
  Antialias antialias = Antialias::kNone;
  double threshold = 16;    // the difference of corners, in 0..255, at which a pixel is split
  int samples = 0;          // at most: pieces of a pixel, points of the lens; 0: 64 and 8
  bool jitter = false;      // moves the samples of pixels, lens and lights
  int depth = 20;           // longest chain of reflections and refractions
  double haze = 0;          // share of the background's colour that a unit of length mixes in
  double aperture = 0;      // radius of the lens
  double focal_length = 0;  // distance at which the picture is sharp; 0: that of `at`
  bool exponential_transparency = true;  // `transparent` is a share per unit of length
};

// Where a scene stands in the coordinates of the file it was read from:
// point_source = scale * point_object + translation.
struct SourceFromObject {
  double scale = 1;
  Eigen::Vector3d translation{0, 0, 0};

  Eigen::Vector3d operator()(const Eigen::Vector3d& object) const {
    return scale * object + translation;
  }
};

struct Scene {
  std::string name;  // the file's name without folder and extension
  std::string file;  // that it was read from; empty: none
  Studio studio;
  std::vector<Surface> surfaces;
  std::vector<Primitive> primitives;  // a primitive's index + 1 is its surface id in pictures
  std::vector<std::string> names;  // by primitive, as a mesh calls it; fewer, or empty: it does not
  std::vector<Light> lights;
  std::vector<std::string> warnings;           // one line each, with file and line
  std::vector<MissingColour> missing_colours;  // that another was given to stand for
  // What a store's key hashes: a Bob scene's preprocessed words, normalised; a mesh's digest.
  std::string source;
  SourceFromObject source_from_object;        // of meshes, which are centred and scaled to fit
  std::optional<std::size_t> merged_colours;  // of a mesh whose colours were merged: into so many
  std::optional<double> chord_error;          // of a STEP file's triangles: see step_mesh.h
  // Every file that was read or looked for, there or not: while what these names hold stays the
  // same, so does the scene.
  std::vector<std::string> files;
};

// Smallest radius of a sphere about the origin that holds every primitive (for cones and rings
// the exact one of their rims).
double bounding_radius(const Scene& scene);

}  // namespace aspect
