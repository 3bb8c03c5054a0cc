#include "tools/doctor/diagnosis.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compiler/scene/mesh_reader.h"
#include "compiler/scene/scene_reader.h"
#include "tools/doctor/colour_checks.h"
#include "tools/doctor/colour_crowd.h"
#include "tools/doctor/merged_colours.h"
#include "tools/doctor/topology_checks.h"
#include "tools/doctor/visibility_checks.h"

namespace aspect {
namespace {

void append(std::vector<Finding>& all, std::vector<Finding> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

// From the file's coordinates.
void bring_into_scene(const SourceFromObject& source, FindingMarks& marks) {
  const auto move = [&](Eigen::Vector3d& point) {
    point = (point - source.translation) / source.scale;
  };
  for (auto& line : marks.lines) std::for_each(line.begin(), line.end(), move);
  for (auto& face : marks.faces) std::for_each(face.begin(), face.end(), move);
  std::for_each(marks.points.begin(), marks.points.end(), move);
}

std::vector<Finding> mesh_findings(const PreparedObject& object, const ColouredMesh& mesh) {
  const std::string extension = lower_extension(object.scene_file);
  std::vector<Finding> findings = check_topology(face_set_of(mesh)).findings;
  for (Finding& finding : findings)
    bring_into_scene(object.scene.source_from_object, finding.marks);
  const bool in_mm = extension == ".step" || extension == ".stp";  // whatever the file's unit
  if (!in_mm) append(findings, check_unit(mesh, extension == ".gltf" || extension == ".glb"));
  return findings;
}

// Of an object with one mesh; empty where its colours are not merged.
Result<std::vector<Finding>> merging_findings(const PreparedObject& object, ColouredMesh mesh) {
  MeshColours colours = mesh_colours(object.settings.mesh);
  const std::optional<std::size_t> count = std::exchange(colours.merged, std::nullopt);
  if (!count) return std::vector<Finding>{};
  if (const std::string fault = repaint(mesh, colours); !fault.empty())
    return Error{fmt::format("{}: {}", object.scene_file.native(), fault)};
  return std::vector{
      merging_finding(mesh, *count, object.settings.options.vision, object.scene_file.string())};
}

std::vector<Finding> colour_findings(const PreparedObject& object, const ColourGroups& groups,
                                     const Sight& sight, const ColourCrowd& crowd) {
  if (crowd.is_one())
    return {crowd_finding(crowd, groups, is_mesh(object), object.scene_file.string())};
  const VisionParameters& vision = object.settings.options.vision;
  std::vector<Finding> findings = check_colours(groups, vision);
  append(findings, check_borders(object.scene, groups, sight, vision));
  return findings;
}

// Places are triangles of the mesh in findings of its topology, surfaces in all others.
void name_places(const Scene& scene, Finding& finding) {
  if (finding.group == "topology") return;
  for (const std::size_t place : finding.where) {
    if (place == 0 || place > scene.names.size()) continue;
    const std::string& name = scene.names[place - 1];
    if (!name.empty()) finding.names.push_back(name);
  }
}

}  // namespace

std::string_view severity_name(Severity severity) {
  switch (severity) {
    case Severity::error:
      return "error";
    case Severity::warning:
      return "warning";
    case Severity::note:
      return "note";
  }
  return "";
}

std::size_t Diagnosis::count(Severity severity) const {
  return static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(),
                    [severity](const Finding& finding) { return finding.severity == severity; }));
}

bool is_mesh(const PreparedObject& object) {
  return lower_extension(object.scene_file) != ".b";
}

WorkingDistance working_distance(const PreparedObject& object) {
  const double own = object.scene.studio.distance;
  const auto& range = object.settings.camera.distance;
  return range ? WorkingDistance{range->front(), range->back(), true}
               : WorkingDistance{own, own, false};
}

Result<Diagnosis> diagnose(const PreparedObject& object) {
  const Scene& scene = object.scene;
  const VisionParameters& vision = object.settings.options.vision;
  const Result<Renderer> renderer = Renderer::create(scene);
  if (!renderer) return Error{fmt::format("{}: {}", object.scene_file.native(), renderer.error())};
  Diagnosis diagnosis{scene.name, scene.primitives.size(), {}};
  std::vector<Finding> merging;
  if (is_mesh(object)) {
    Result<ColouredMesh> mesh = read_coloured_mesh(object.scene_file, kUncoloured,
                                                   scene.chord_error.value_or(kDefaultChordError));
    if (!mesh) return Error{mesh.error()};
    append(diagnosis.findings, mesh_findings(object, mesh.value()));
    Result<std::vector<Finding>> found = merging_findings(object, std::move(mesh).value());
    if (!found) return Error{found.error()};
    merging = std::move(found).value();
  } else {
    append(diagnosis.findings, check_topology(face_set_of(scene)).findings);
    append(diagnosis.findings, check_rims(scene));
  }
  const WorkingDistance distance = working_distance(object);
  append(diagnosis.findings, check_place(scene, distance));
  append(diagnosis.findings, check_missing(scene, object.settings.mesh.missing_colour.has_value()));
  const ColourGroups groups = colour_groups(scene);
  const Sight sight = look_around(scene, renderer.value(), groups, vision, distance.far);
  const ColourCrowd crowd = find_crowd(groups, sight, vision);
  append(diagnosis.findings, std::move(merging));
  append(diagnosis.findings, colour_findings(object, groups, sight, crowd));
  append(diagnosis.findings, check_darkness(scene, groups, sight, vision));
  const auto is_crumb = [&](std::size_t part) { return crowd.has_primitive(groups, part); };
  append(diagnosis.findings, check_visibility(sight, vision, distance.far, is_crumb));
  for (Finding& finding : diagnosis.findings) name_places(scene, finding);
  return diagnosis;
}

}  // namespace aspect
