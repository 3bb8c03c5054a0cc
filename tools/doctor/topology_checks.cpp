#include "tools/doctor/topology_checks.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "tools/doctor/face_winding.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

constexpr std::string_view kGroup = "topology";
// Of the square of the size; below it a Bob scene refuses a polygon (bob_writer.cpp).
constexpr double kLeastArea = 2e-9;

void note_place(Finding& finding, std::size_t place) {
  auto& where = finding.where;
  if (where.size() < Finding::kMostPlaces &&
      std::find(where.begin(), where.end(), place) == where.end())
    where.push_back(place);
}

void mark_face(Finding& finding, const FaceSet& set, std::size_t face) {
  if (finding.marks.faces.size() == FindingMarks::kMost) return;
  std::vector<Vector3d>& corners = finding.marks.faces.emplace_back();
  for (const std::uint32_t corner : set.corners_of(face)) corners.push_back(set.vertices[corner]);
}

// As a place, by its number in the file, and for pictures.
void note_face(Finding& finding, const FaceSet& set, std::size_t face) {
  note_place(finding, set.faces[face].number + 1);
  mark_face(finding, set, face);
}

void note_edge(Finding& finding, const FaceSet& set, const BorderPiece& piece) {
  note_place(finding, set.faces[piece.face].number + 1);
  if (finding.marks.lines.size() < FindingMarks::kMost)
    finding.marks.lines.push_back({set.vertices[piece.from], set.vertices[piece.to]});
}

bool has_area(const FaceSet& set, std::size_t face) {
  const auto corners = set.corners_of(face);
  const Vector3d& origin = set.vertices[corners[0]];
  Vector3d doubled = Vector3d::Zero();
  double size = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector3d &a = set.vertices[corners[k]],
                   &b = set.vertices[corners[(k + 1) % corners.size()]];
    doubled += (a - origin).cross(b - origin);
    size = std::max({size, 2 * (b - a).norm(), 2 * (a - origin).norm()});
  }
  return doubled.norm() / 2 > kLeastArea * size * size;
}

Finding leave_out_empty(const FaceSet& set, std::vector<bool>& kept) {
  Finding finding{kGroup, "zero_area_faces", Severity::warning, "", "", 0, {}, true};
  for (std::size_t face = 0; face < set.faces.size(); ++face) {
    if (has_area(set, face)) continue;
    kept[face] = false;
    ++finding.count;
    note_face(finding, set, face);
  }
  finding.message = fmt::format("faces without area: {} of {}", finding.count, set.faces.size());
  finding.cure = "remove them; --fix does";
  return finding;
}

// The earliest of alike faces stays.
std::vector<Finding> leave_out_repeated(const FaceSet& set, std::vector<bool>& kept) {
  Finding same{kGroup, "duplicate_faces", Severity::warning, "", "remove them; --fix does", 0, {},
               true};
  Finding clash{kGroup,
                "clashing_faces",
                Severity::error,
                "",
                "keep the one that is meant; --fix keeps the first",
                0,
                {},
                true};
  std::vector<std::pair<std::vector<std::uint32_t>, std::size_t>> keys;
  for (std::size_t face = 0; face < set.faces.size(); ++face) {
    if (!kept[face]) continue;
    const auto corners = set.corners_of(face);
    keys.emplace_back(std::vector(corners.begin(), corners.end()), face);
    std::sort(keys.back().first.begin(), keys.back().first.end());
  }
  std::sort(keys.begin(), keys.end());
  std::size_t first = 0;
  for (std::size_t k = 1; k < keys.size(); ++k) {
    if (keys[k].first != keys[first].first) {
      first = k;
      continue;
    }
    const FaceSet::Face& face = set.faces[keys[k].second];
    const bool alike = face.colour == set.faces[keys[first].second].colour;
    Finding& finding = alike ? same : clash;
    kept[keys[k].second] = false;
    ++finding.count;
    note_face(finding, set, keys[k].second);
  }
  same.message = fmt::format("faces that repeat another one of the same colour: {}", same.count);
  clash.message = fmt::format(
      "faces that lie on another one of another colour, so that chance decides which is "
      "seen: {}",
      clash.count);
  return {same, clash};
}

Finding cracks_of(const FaceSet& set) {
  Finding finding{
      kGroup,
      "cracked_vertices",
      Severity::warning,
      fmt::format("vertices within {:.2g} of another one, of a size of {:.4g}, so that faces "
                  "look joined and are not: {}",
                  set.tolerance, set.diameter, set.cracked),
      "merge vertices by distance; --fix does",
      set.cracked,
      {},
      true};
  for (const std::uint32_t vertex : set.cracks)
    finding.marks.points.push_back(set.vertices[vertex]);
  return finding;
}

std::vector<Finding> edge_findings(const FaceSet& set, const FaceEdges& edges) {
  Finding open{kGroup,
               "open_edges",
               Severity::warning,
               "",
               "close the holes in the model; --fix cannot know what belongs there",
               edges.open.size(),
               {},
               false};
  double length = 0;
  for (const BorderPiece& piece : edges.open) {
    length += (set.vertices[piece.to] - set.vertices[piece.from]).norm();
    note_edge(open, set, piece);
  }
  open.message =
      fmt::format("open edges, through which the inside can be seen: {}, {:.4g} long together",
                  open.count, length);
  // Parts of a Bob scene are set against each other; only a mesh means to be one surface.
  Finding crowded{
      kGroup,
      "crowded_edges",
      set.wound ? Severity::warning : Severity::note,
      "",
      "separate the parts, or remove the walls between them; harmless where parts touch",
      edges.crowded.size(),
      {},
      false};
  crowded.message = fmt::format("edges of more than two faces: {}", crowded.count);
  for (const BorderPiece& piece : edges.crowded) note_edge(crowded, set, piece);
  return {open, crowded};
}

std::vector<Finding> winding_findings(const FaceSet& set, const FaceWinding& winding) {
  Finding flipped{
      kGroup,
      "flipped_faces",
      Severity::warning,
      fmt::format("faces that show another side than their neighbours: {}", winding.flipped_count),
      "turn them; --fix does. Seen from both sides here, but holes elsewhere",
      winding.flipped_count,
      {},
      true};
  Finding inverted{kGroup,
                   "inside_out",
                   Severity::warning,
                   fmt::format("closed pieces wound inside out: {}", winding.inside_out),
                   "turn all of their faces; --fix does. Seen from both sides here, but hollow "
                   "elsewhere",
                   winding.inside_out,
                   {},
                   true};
  for (const std::size_t face : winding.inside_out_faces)
    note_place(inverted, set.faces[face].number + 1);
  std::vector<bool> is_inverted(set.faces.size(), false);
  for (const std::uint32_t face : winding.inverted) {
    is_inverted[face] = true;
    mark_face(inverted, set, face);
  }
  for (std::size_t face = 0; face < set.faces.size() && flipped.count > 0; ++face)
    if (winding.flipped[face] && !is_inverted[face]) note_face(flipped, set, face);
  Finding twisted{kGroup,
                  "one_sided",
                  Severity::warning,
                  fmt::format("pieces of one side only, as a Moebius strip: {}", winding.one_sided),
                  "cut them open where faces meet head to head",
                  winding.one_sided,
                  {},
                  false};
  for (const std::uint32_t face : winding.without_sides) note_face(twisted, set, face);
  return {flipped, inverted, twisted};
}

}  // namespace

Topology check_topology(const FaceSet& set) {
  Topology topology;
  topology.kept.assign(set.faces.size(), true);
  topology.flipped.assign(set.faces.size(), false);
  std::vector<Finding> all = {leave_out_empty(set, topology.kept)};
  const auto append = [&](const std::vector<Finding>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  append(leave_out_repeated(set, topology.kept));
  append({cracks_of(set)});
  const FaceEdges edges = face_edges(set, topology.kept);
  append(edge_findings(set, edges));
  if (set.wound) {
    const FaceWinding winding = face_winding(set, topology.kept, edges);
    topology.flipped = winding.flipped;
    append(winding_findings(set, winding));
  }
  for (const Finding& finding : all)
    if (finding.count > 0) topology.findings.push_back(finding);
  return topology;
}

}  // namespace aspect
