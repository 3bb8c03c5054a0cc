// The lines and arcs of a DXF file that a thickness makes surfaces of.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "compiler/scene/dxf_groups.h"

namespace aspect {

// Points one after the other, in the entity's own coordinates.
struct DxfPath {
  std::vector<Eigen::Vector3d> points;
  bool closed = false;
  bool wide = false;  // drawn as a band, not as a line
};

// Chords of this many to the full circle: at most 0.12 % of the radius off.
inline constexpr int kChordsPerTurn = 64;

DxfPath path_of_circle(const DxfRecord& circle);
DxfPath path_of_arc(const DxfRecord& arc);
// Bulges are arcs (group 42). Throw MeshError past ColouredMesh::kMaxVertices points.
DxfPath path_of_lwpolyline(const DxfRecord& polyline);
DxfPath path_of_polyline(const DxfRecord& polyline, std::span<const DxfRecord> vertices);

}  // namespace aspect
