#include "tools/doctor/diagnosis.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/scene/mesh_reader.h"
#include "compiler/scene/scene_reader.h"
#include "tools/doctor/colour_checks.h"
#include "tools/doctor/topology_checks.h"
#include "tools/doctor/visibility_checks.h"

namespace aspect {
namespace {

void append(std::vector<Finding>& all, std::vector<Finding> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

Result<std::vector<Finding>> mesh_findings(const PreparedObject& object) {
  const Result<ColouredMesh> mesh = read_coloured_mesh(object.scene_file);
  if (!mesh) return Error{mesh.error()};
  const std::string extension = lower_extension(object.scene_file);
  std::vector<Finding> findings = check_topology(face_set_of(mesh.value())).findings;
  append(findings, check_unit(mesh.value(), extension == ".gltf" || extension == ".glb"));
  return findings;
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
  if (is_mesh(object)) {
    Result<std::vector<Finding>> findings = mesh_findings(object);
    if (!findings) return Error{findings.error()};
    append(diagnosis.findings, std::move(findings).value());
  } else {
    append(diagnosis.findings, check_topology(face_set_of(scene)).findings);
    append(diagnosis.findings, check_rims(scene));
  }
  const WorkingDistance distance = working_distance(object);
  append(diagnosis.findings, check_place(scene, distance));
  append(diagnosis.findings, check_missing(scene, object.settings.mesh.missing_colour.has_value()));
  const ColourGroups groups = colour_groups(scene);
  append(diagnosis.findings, check_colours(groups, vision));
  const Sight sight = look_around(scene, renderer.value(), groups, vision, distance.far);
  append(diagnosis.findings, check_borders(scene, groups, sight, vision));
  append(diagnosis.findings, check_darkness(scene, groups, sight, vision));
  append(diagnosis.findings, check_visibility(sight, vision, distance.far));
  return diagnosis;
}

}  // namespace aspect
