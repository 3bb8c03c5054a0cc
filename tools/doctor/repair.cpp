#include "tools/doctor/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "compiler/scene/mesh_reader.h"
#include "compiler/scene/scene_extent.h"
#include "tools/aspectc/project/distance_check.h"
#include "tools/aspectc/project/scene_settings.h"
#include "tools/doctor/diagnosis.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

constexpr double kShareOfPicture = 0.9;  // as meshes are placed (mesh_scene.cpp)
constexpr double kSameColour = 2.0 / 255;

// scale * (point - centre) + at.
struct Placing {
  Vector3d centre{0, 0, 0}, at{0, 0, 0};
  double scale = 1;

  void move(Vector3d& point) const { point = scale * (point - centre) + at; }
  void operator()(Polygon& polygon) const {
    for (Vector3d& vertex : polygon.vertices) move(vertex);
  }
  void operator()(Mesh& mesh) const {
    for (Vector3d& vertex : mesh.vertices) move(vertex);
  }
  void operator()(SmoothTriangle& triangle) const {
    for (Vector3d& vertex : triangle.vertices) move(vertex);
  }
  void operator()(Sphere& sphere) const {
    move(sphere.center);
    sphere.radius *= scale;
  }
  void operator()(Ring& ring) const {
    move(ring.center);
    ring.min_radius *= scale;
    ring.max_radius *= scale;
  }
  void operator()(Cone& cone) const {
    move(cone.base);
    move(cone.apex);
    cone.base_radius *= scale;
    cone.apex_radius *= scale;
  }
};

void place(Scene& scene, const Placing& placing) {
  for (Primitive& primitive : scene.primitives) std::visit(placing, primitive.shape);
  for (Light& light : scene.lights) placing.move(light.position);
  SourceFromObject& source = scene.source_from_object;
  source.translation += source.scale * (placing.centre - placing.at / placing.scale);
  source.scale /= placing.scale;
}

bool has(const std::vector<Finding>& findings, std::string_view code) {
  return std::any_of(findings.begin(), findings.end(),
                     [&](const Finding& finding) { return finding.code == code; });
}

void mend_place(Scene& scene, const WorkingDistance& distance, std::vector<std::string>& done) {
  const Vector3d at = scene.studio.at;
  if (has(check_place(scene, distance), "off_centre")) {
    const SceneExtent extent = scene_extent(scene);
    const Vector3d centre = (extent.least + extent.most) / 2;
    place(scene, {centre, at, 1});
    done.push_back(fmt::format("centred: moved by {:.4g} {:.4g} {:.4g}", at.x() - centre.x() + 0.0,
                               at.y() - centre.y(), at.z() - centre.z()));
  }
  const std::vector<Finding> left = check_place(scene, distance);
  if (distance.given || !(has(left, "leaves_picture") || has(left, "small_in_picture"))) return;
  const double scale =
      kShareOfPicture * radius_that_fits(scene.studio, distance) / radius_around(scene, at);
  place(scene, {at, at, scale});
  done.push_back(fmt::format("scaled by {:.6g}", scale));
}

// What check_topology() found, done.
void note_done(const Topology& topology, std::vector<std::string>& done) {
  for (const Finding& finding : topology.findings)
    if (finding.can_fix) done.push_back(fmt::format("cured {}: {}", finding.code, finding.message));
}

Result<Done> mend_mesh(const PreparedObject& object, Repair& repaired) {
  const MeshColours colours = mesh_colours(object.settings.mesh);
  const Result<ColouredMesh> mesh =
      read_coloured_mesh(object.scene_file, colours.missing.value_or(kUncoloured),
                         object.scene.chord_error.value_or(kDefaultChordError));
  if (!mesh) return Error{mesh.error()};
  const FaceSet set = face_set_of(mesh.value());
  const Topology topology = check_topology(set);
  note_done(topology, repaired.done);
  repaired.mesh = repaired_mesh(mesh.value(), set, topology);
  if (const std::string fault = repaint(*repaired.mesh, colours); !fault.empty())
    return Error{fmt::format("{}: {}", object.scene_file.native(), fault)};
  Result<Scene> scene = scene_of_mesh(*repaired.mesh);
  if (!scene) return Error{fmt::format("{}: {}", object.scene_file.native(), scene.error())};
  repaired.scene = std::move(scene).value();
  repaired.scene.name = object.scene.name;
  return apply_settings(object.settings, repaired.scene);
}

void mend_scene(const PreparedObject& object, Repair& repaired) {
  repaired.scene = object.scene;
  const FaceSet set = face_set_of(object.scene);
  const Topology topology = check_topology(set);
  note_done(topology, repaired.done);
  std::vector<bool> dropped(object.scene.primitives.size(), false);
  for (std::size_t face = 0; face < set.faces.size(); ++face)
    if (!topology.kept[face]) dropped[set.faces[face].number] = true;
  repaired.scene.primitives.clear();
  for (std::size_t k = 0; k < dropped.size(); ++k)
    if (!dropped[k]) repaired.scene.primitives.push_back(object.scene.primitives[k]);
}

// The colours of a mesh that were moved in its scene.
void follow(const std::vector<ColourMove>& moves, ColouredMesh& mesh) {
  for (const ColourMove& move : moves)
    for (Vector3d& colour : mesh.colours)
      if ((colour - move.before).cwiseAbs().maxCoeff() <= kSameColour) colour = move.after;
}

}  // namespace

ColouredMesh repaired_mesh(const ColouredMesh& mesh, const FaceSet& set, const Topology& topology) {
  ColouredMesh repaired;
  repaired.vertices = set.vertices;
  repaired.parts = mesh.parts;
  for (std::size_t face = 0; face < set.faces.size(); ++face) {
    if (!topology.kept[face]) continue;
    const auto corners = set.corners_of(face);
    std::array<std::uint32_t, 3> triangle = {corners[0], corners[1], corners[2]};
    if (topology.flipped[face]) std::swap(triangle[1], triangle[2]);
    repaired.triangles.push_back(triangle);
    repaired.colours.push_back(mesh.colours[face]);
    repaired.part_of.push_back(mesh.part_of[face]);
  }
  return repaired;
}

Result<Repair> repair(const PreparedObject& object) {
  Repair repaired;
  if (is_mesh(object)) {
    if (const auto done = mend_mesh(object, repaired); !done) return Error{done.error()};
  } else {
    mend_scene(object, repaired);
  }
  const WorkingDistance distance = working_distance(object);
  mend_place(repaired.scene, distance, repaired.done);
  const Result<Renderer> renderer = Renderer::create(repaired.scene);
  if (!renderer) return Error{fmt::format("{}: {}", object.scene_file.native(), renderer.error())};
  const VisionParameters& vision = object.settings.options.vision;
  const ColourGroups groups = colour_groups(repaired.scene);
  const Sight sight = look_around(repaired.scene, renderer.value(), groups, vision, distance.far);
  repaired.moves = separate_colours(repaired.scene, groups, sight, vision);
  if (repaired.mesh) follow(repaired.moves, *repaired.mesh);
  return repaired;
}

std::string ply_text(const ColouredMesh& mesh) {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list uchar uint vertex_indices\n"
      "property float red\nproperty float green\nproperty float blue\nend_header\n",
      mesh.vertices.size(), mesh.triangles.size());
  for (const Vector3d& vertex : mesh.vertices)
    fmt::format_to(std::back_inserter(text), "{:.17g} {:.17g} {:.17g}\n", vertex.x(), vertex.y(),
                   vertex.z());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vector3d& colour = mesh.colours[t];
    fmt::format_to(std::back_inserter(text), "3 {} {} {} {:.9g} {:.9g} {:.9g}\n", a, b, c,
                   colour.x(), colour.y(), colour.z());
  }
  return text;
}

}  // namespace aspect
