// A patch that belongs to several classes, cut where their borders cross its edges.
//
// Round the patch, from corner 0 along edges (0,1), (1,2), (2,0), a place is the number of the edge
// plus the share of it that lies behind: 0 <= place < 3. The patch is a flat triangle here, which
// is what share and area of a small spherical one come to.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "compiler/viewsphere/viewsphere.h"

namespace aspect {

inline constexpr std::int32_t kNoClass = -1;

// Class classes[k] touches the edges from places[k] to the next place, and its piece of the patch
// is what lies between there and the middle of all places: with two of them the chord cuts the
// patch in two, with three the borders meet in a point. At least two places, rising.
struct PatchDivision {
  std::vector<double> places;
  std::vector<std::int32_t> classes;
};

// From the classes along the edges: classes[k] from places[k] on, wherever the next one starts.
// Equal neighbours are joined; fewer than two places are left where one class has it all.
PatchDivision joined(const PatchDivision& along_edges);

// The piece's share of the patch's area, by place. They sum to 1.
std::vector<double> piece_shares(const PatchDivision& division);

// The pieces as triangles, for drawing: each has one side on an edge of the patch, from a place to
// a later one of the same edge, and its third corner in the middle. Together they are the patch.
struct DivisionTriangle {
  std::int32_t class_id = kNoClass;
  double from = 0, to = 0;  // places; a corner that ends an edge is a whole number up to 3
};
std::vector<DivisionTriangle> division_triangles(const PatchDivision& division);

// Barycentric coordinates of the middle.
Eigen::Vector3d division_middle(const PatchDivision& division);

// The class at a point given by its barycentric coordinates.
std::int32_t class_at(const PatchDivision& division, const Eigen::Vector3d& barycentric);

// Which class every direction is of.
struct SphereClasses {
  std::vector<std::int32_t> class_of;                          // by patch; meaningful for leaves
  std::unordered_map<std::uint32_t, PatchDivision> divisions;  // of leaves that are divided

  std::int32_t at(const ViewSphere& sphere, const Eigen::Vector3d& direction) const;
};

// Coordinates of a direction in a patch: it is the sum of the corners with these weights, which add
// up to 1, scaled.
Eigen::Vector3d barycentric(const ViewSphere& sphere, PatchId patch,
                            const Eigen::Vector3d& direction);

}  // namespace aspect
