#include "compiler/scene/bob_writer.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <iterator>

#include "compiler/scene/bob_parser.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

// A little above what the reader asks of a polygon.
constexpr double kLeastArea = 2e-9, kLeastSize = 2e-9;

std::string words(const Vector3d& v) {
  return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z());
}

bool has_area(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double size = 2 * std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return size >= kLeastSize && (b - a).cross(c - a).norm() / 2 > kLeastArea * size * size;
}

class BobWriter {
 public:
  std::string write(const Scene& scene) {
    studio(scene.studio);
    for (const Light& light : scene.lights) add(light);
    const Surface* last = nullptr;
    for (const Primitive& primitive : scene.primitives) {
      const Surface* used = &scene.surfaces[static_cast<std::size_t>(primitive.surface)];
      if (used != last) surface(*used);
      last = used;
      std::visit([this](const auto& shape) { add(shape); }, primitive.shape);
    }
    return std::move(text_);
  }

  std::size_t primitives() const { return primitives_; }

 private:
  template <typename... Values>
  void append(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }

  void studio(const Studio& studio) {
    append("studio {{\n  at {}\n  up {}\n  angle {:.17g}\n  resolution {} {}\n  aspect {:.17g}\n",
           words(studio.at), words(studio.up), studio.angle_deg, studio.width_px, studio.height_px,
           studio.aspect);
    append("  ambient {}\n  background {}\n", words(studio.ambient), words(studio.background));
    const Studio plain;
    if (studio.projection == Projection::kOrthogonal)
      append("  project orthogonal {:.17g}\n", studio.width);
    constexpr std::array kAntialias = {"none", "quick", "corners", "adaptive"};
    append("  antialias {} threshold {:.17g}{}\n",
           kAntialias[static_cast<std::size_t>(studio.antialias)], studio.threshold,
           studio.jitter ? " jitter" : "");
    if (studio.samples != plain.samples) append("  samples {}\n", studio.samples);
    append("  depth {} haze {:.17g} aperture {:.17g}\n", studio.depth, studio.haze,
           studio.aperture);
    if (studio.focal_length > 0) append("  focal_length {:.17g}\n", studio.focal_length);
    append("{}}}\n", studio.exponential_transparency ? "" : "  no_exp_trans\n");
  }

  void add(const Light& light) {
    constexpr std::array kTypes = {"point", "directional", "spherical"};
    append("light {{ type {} color {}{}", kTypes[static_cast<std::size_t>(light.type)],
           words(light.color), light.casts_shadows ? "" : " no_shadows");
    if (light.type == Light::Type::kDirectional)
      append(" direction {}", words(light.direction));
    else
      append(" position {} falloff {}", words(light.position), light.falloff);
    if (light.type == Light::Type::kSpherical)
      append(" radius {:.17g} samples {}", light.radius, light.samples);
    if (light.spot)
      append(" at {} min_angle {:.17g} max_angle {:.17g}", words(light.spot->at),
             light.spot->min_angle_deg, light.spot->max_angle_deg);
    append(" }}\n");
  }

  void surface(const Surface& surface) {
    append("surface {{ diffuse {}", words(surface.diffuse));
    if (surface.ambient != surface.diffuse) append(" ambient {}", words(surface.ambient));
    if (!surface.specular.isZero(0)) append(" specular {}", words(surface.specular));
    if (!surface.transparent.isZero(0))
      append(" transparent {} ior {:.17g}", words(surface.transparent), surface.ior);
    if (surface.shine > 0) append(" shine {:.17g} {}", surface.shine, words(surface.shine_color));
    if (surface.fuzz > 0) append(" fuzz {:.17g}", surface.fuzz);
    append("{}{} }}\n", surface.antialias ? "" : " no_antialias",
           surface.casts_shadow ? "" : " no_shadow");
  }

  void add(const Polygon& polygon) {
    ++primitives_;
    append("polygon {{ points {}", polygon.vertices.size());
    for (const Vector3d& vertex : polygon.vertices) append(" vertex {}", words(vertex));
    append(" }}\n");
  }
  void add(const Sphere& sphere) {
    ++primitives_;
    append("sphere {{ center {} radius {:.17g} }}\n", words(sphere.center), sphere.radius);
  }
  void add(const Ring& ring) {
    ++primitives_;
    append("ring {{ center {} normal {} min_radius {:.17g} max_radius {:.17g} }}\n",
           words(ring.center), words(ring.normal), ring.min_radius, ring.max_radius);
  }
  void add(const Cone& cone) {
    ++primitives_;
    append("cone {{ base {} base_radius {:.17g} apex {} apex_radius {:.17g} }}\n", words(cone.base),
           cone.base_radius, words(cone.apex), cone.apex_radius);
  }
  void add(const SmoothTriangle& triangle) {
    ++primitives_;
    append("patch {{");
    for (std::size_t k = 0; k < 3; ++k)
      append(" vertex {} normal {}", words(triangle.vertices[k]), words(triangle.normals[k]));
    append(" }}\n");
  }
  void add(const Mesh& mesh) {
    for (const auto& [a, b, c] : mesh.triangles)
      if (has_area(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]))
        add(Polygon{{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}});
  }

  std::string text_;
  std::size_t primitives_ = 0;
};

}  // namespace

Result<std::string> write_bob(const Scene& scene) {
  for (const Surface& surface : scene.surfaces)
    if (surface.texture)
      return Error{scene.name +
                   ": has textures, which are not written; use the scene itself, or give its "
                   "surfaces plain colours"};
  BobWriter writer;
  std::string text = writer.write(scene);
  if (writer.primitives() > BobParser::kMaxPrimitives)
    return Error{fmt::format("{}: {} polygons, a Bob scene has at most {}; compile the mesh itself",
                             scene.name, writer.primitives(), BobParser::kMaxPrimitives)};
  const SourceFromObject& source = scene.source_from_object;
  return fmt::format("/* source = {:.17g} * object + ({}) */\n{}", source.scale,
                     words(source.translation), text);
}

}  // namespace aspect
