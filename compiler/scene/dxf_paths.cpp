#include "compiler/scene/dxf_paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aspect {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

// A corner of a polyline and the way to the next: a bulge is the tangent of a quarter of the arc's
// angle, above zero counter-clockwise.
struct Corner {
  Vector3d place;
  double bulge = 0;
};

int chords_of(double angle) {
  return std::max(1,
                  static_cast<int>(std::ceil(std::abs(angle) / (2 * pi) * kChordsPerTurn - 1e-9)));
}

// Behind `from`, up to `to` and without it.
void append_bulge(const Vector3d& from, const Vector3d& to, double bulge,
                  std::vector<Vector3d>& points) {
  const double angle = 4 * std::atan(bulge);
  const int chords = chords_of(angle);
  const Vector3d chord = to - from;
  if (chords == 1 || !(chord.norm() > 0)) return;
  const Vector3d left(-chord.y(), chord.x(), 0);
  const Vector3d centre = (from + to) / 2 + left * (1 - bulge * bulge) / (4 * bulge);
  const Vector3d arm = from - centre;
  for (int k = 1; k < chords; ++k) {
    const double turn = angle * k / chords, c = std::cos(turn), s = std::sin(turn);
    points.emplace_back(centre.x() + c * arm.x() - s * arm.y(),
                        centre.y() + s * arm.x() + c * arm.y(), from.z());
  }
}

std::vector<Vector3d> points_of(const std::vector<Corner>& corners, bool closed, std::size_t line) {
  std::vector<Vector3d> points;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    points.push_back(corners[k].place);
    const bool last = k + 1 == corners.size();
    if (!last || closed)
      append_bulge(corners[k].place, corners[last ? 0 : k + 1].place, corners[k].bulge, points);
    if (points.size() > ColouredMesh::kMaxVertices)
      throw MeshError(fmt::format("a polyline of more than {} points; simplify the model",
                                  ColouredMesh::kMaxVertices),
                      line);
  }
  return points;
}

// From `begin` on, counter-clockwise; with its last point where it is not the whole circle.
std::vector<Vector3d> arc(const DxfRecord& entity, double begin, double angle, bool whole) {
  const Vector3d centre = entity.point(10);
  const double radius = entity.number(40, 0);
  const int chords = chords_of(angle);
  std::vector<Vector3d> points;
  for (int k = 0; k < chords + (whole ? 0 : 1); ++k) {
    const double at = begin + angle * k / chords;
    points.emplace_back(centre + radius * Vector3d(std::cos(at), std::sin(at), 0));
  }
  return points;
}

}  // namespace

DxfPath path_of_circle(const DxfRecord& circle) {
  return {arc(circle, 0, 2 * pi, true), true, false};
}

DxfPath path_of_arc(const DxfRecord& record) {
  const double begin_deg = std::fmod(record.number(50, 0), 360);
  double angle_deg = std::fmod(record.number(51, 360) - begin_deg, 360);
  if (angle_deg <= 0) angle_deg += 360;
  return {arc(record, begin_deg * pi / 180, angle_deg * pi / 180, false), false, false};
}

DxfPath path_of_lwpolyline(const DxfRecord& polyline) {
  const double elevation = polyline.number(38, 0);
  std::vector<Corner> corners;
  DxfPath path;
  path.closed = (polyline.whole(70, 0) & 1) != 0;
  path.wide = polyline.number(43, 0) > 0;
  for (const DxfGroup& group : polyline.groups) {
    if (group.code == 10) corners.push_back({{polyline.number_in(group), 0, elevation}});
    if (corners.empty()) continue;
    if (group.code == 20) corners.back().place.y() = polyline.number_in(group);
    if (group.code == 42) corners.back().bulge = polyline.number_in(group);
    if (group.code == 40 || group.code == 41)
      path.wide = path.wide || polyline.number_in(group) > 0;
  }
  path.points = points_of(corners, path.closed, polyline.line);
  return path;
}

DxfPath path_of_polyline(const DxfRecord& polyline, std::span<const DxfRecord> vertices) {
  constexpr int kSplineControlPoint = 16;
  const double elevation = polyline.number(30, 0);
  std::vector<Corner> corners;
  DxfPath path;
  path.closed = (polyline.whole(70, 0) & 1) != 0;
  const double widths[] = {polyline.number(40, 0), polyline.number(41, 0)};
  for (const DxfRecord& vertex : vertices) {
    if ((vertex.whole(70, 0) & kSplineControlPoint) != 0) continue;
    corners.push_back({vertex.point(10), vertex.number(42, 0)});
    // Its own height is the polyline's again, or left out.
    if (elevation != 0) corners.back().place.z() = elevation;
    path.wide = path.wide || vertex.number(40, widths[0]) > 0 || vertex.number(41, widths[1]) > 0;
  }
  path.points = points_of(corners, path.closed, polyline.line);
  return path;
}

}  // namespace aspect
