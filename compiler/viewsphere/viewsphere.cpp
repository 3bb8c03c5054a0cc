// Idea: the patches form 20 quadtrees that never lose a node, linked crosswise between patches of
// the same level. A child that touches edge k of its parent does so with its own edge k, so edge
// numbers stay the same on the way down and up a tree.
// Weak side: memory for the inner nodes, a third on top of the leaves.
// Arithmetic is spelled out where a result decides something later: Eigen sums three products in an
// order that depends on the machine's vector unit, and libm's last bit depends on the machine too.
#include "compiler/viewsphere/viewsphere.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "runtime/base/check.h"

namespace aspect {
namespace {

constexpr PatchId kNone{std::numeric_limits<std::uint32_t>::max()};
constexpr std::size_t kRoots = 20;
constexpr std::size_t kMiddle = 3;  // place of the middle one among the children

constexpr std::size_t next(std::size_t corner) {
  return (corner + 1) % 3;
}
constexpr std::size_t previous(std::size_t corner) {
  return (corner + 2) % 3;
}

std::size_t index_of(VertexId vertex) {
  return static_cast<std::size_t>(vertex);
}
std::size_t index_of(PatchId patch) {
  return static_cast<std::size_t>(patch);
}

double dot(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

Eigen::Vector3d normalised(const Eigen::Vector3d& vector) {
  return vector / std::sqrt(dot(vector, vector));
}

// Exact to the last few bits for 0 <= x <= 0.33, the tangent of half a level 0 patch's area: one
// halving of the angle brings x below 0.16, where the eleventh term of the series is below 1e-17.
double arc_tangent(double x) {
  const double half = x / (1 + std::sqrt(1 + x * x));
  const double square = half * half;
  double sum = 0;
  for (int term = 11; term >= 0; --term) sum = 1.0 / (2 * term + 1) - square * sum;
  return 2 * half * sum;
}

// A pole, the five vertices around it counter-clockwise, and the antipodes of all six. The lower
// ring's vertex k lies between the upper ring's k and k + 1, which makes it the antipode of k + 3.
std::vector<Eigen::Vector3d> icosahedron_vertices() {
  constexpr double kPhi = std::numbers::phi;
  const Eigen::Vector3d pole(0, 1, kPhi);
  const std::array<Eigen::Vector3d, 5> ring{
      Eigen::Vector3d(0, -1, kPhi), Eigen::Vector3d(kPhi, 0, 1), Eigen::Vector3d(1, kPhi, 0),
      Eigen::Vector3d(-1, kPhi, 0), Eigen::Vector3d(-kPhi, 0, 1)};
  std::vector<Eigen::Vector3d> vertices{pole};
  vertices.insert(vertices.end(), ring.begin(), ring.end());
  // Subtracted from zero, not negated: there must be no -0.0, which would differ from 0.0 in bits.
  for (std::size_t k = 0; k < 5; ++k) {
    vertices.push_back(Eigen::Vector3d::Zero() - ring[(k + 3) % 5]);
  }
  vertices.push_back(Eigen::Vector3d::Zero() - pole);
  for (Eigen::Vector3d& vertex : vertices) vertex = normalised(vertex);
  return vertices;
}

}  // namespace

ViewSphere::ViewSphere() : vertices_(icosahedron_vertices()) {
  constexpr VertexId kNorth{0};
  constexpr VertexId kSouth{11};
  for (std::uint32_t k = 0; k < 5; ++k) {
    const std::uint32_t after = (k + 1) % 5;
    const VertexId upper{1 + k};
    const VertexId upper_after{1 + after};
    const VertexId lower{6 + k};
    const VertexId lower_after{6 + after};
    add_patch({kNorth, upper, upper_after}, 0, kNone);
    add_patch({upper, lower, upper_after}, 0, kNone);
    add_patch({lower, lower_after, upper_after}, 0, kNone);
    add_patch({kSouth, lower_after, lower}, 0, kNone);
  }
  link_level_0();
}

const Eigen::Vector3d& ViewSphere::position(VertexId vertex) const {
  ASPECT_DCHECK(index_of(vertex) < vertices_.size());
  return vertices_[index_of(vertex)];
}

const Patch& ViewSphere::patch(PatchId patch) const {
  ASPECT_DCHECK(index_of(patch) < patches_.size());
  return patches_[index_of(patch)];
}

const ViewSphere::Links& ViewSphere::links(PatchId patch) const {
  return links_[index_of(patch)];
}
ViewSphere::Links& ViewSphere::links(PatchId patch) {
  return links_[index_of(patch)];
}

PatchId ViewSphere::add_patch(const std::array<VertexId, 3>& corners, int level, PatchId parent) {
  const PatchId added{static_cast<std::uint32_t>(patches_.size())};
  ASPECT_CHECK(added != kNone);
  patches_.push_back({corners, level, false, {}});
  links_.push_back({parent, {kNone, kNone, kNone}});
  return added;
}

void ViewSphere::link_level_0() {
  for (std::uint32_t a = 0; a < kRoots; ++a) {
    for (std::uint32_t b = 0; b < kRoots; ++b) {
      for (std::size_t edge = 0; edge < 9; ++edge) {
        const auto& ours = patches_[a].corners;
        const auto& theirs = patches_[b].corners;
        const std::size_t i = edge / 3;
        const std::size_t j = edge % 3;
        const bool shared = ours[i] == theirs[next(j)] && ours[next(i)] == theirs[j];
        if (shared) links_[a].across[i] = PatchId{b};
      }
    }
  }
}

std::size_t ViewSphere::edge_towards(PatchId patch, PatchId neighbour) const {
  const auto& across = links(patch).across;
  const auto found = std::find(across.begin(), across.end(), neighbour);
  ASPECT_DCHECK(found != across.end());
  return static_cast<std::size_t>(found - across.begin());
}

VertexId ViewSphere::midpoint(PatchId patch_id, std::size_t edge) {
  const PatchId other = links(patch_id).across[edge];
  if (other != kNone && patch(other).split) {
    const std::size_t their_edge = edge_towards(other, patch_id);
    return patch(patch(other).children[kMiddle]).corners[previous(their_edge)];
  }
  const auto& corners = patch(patch_id).corners;
  const Eigen::Vector3d sum = position(corners[edge]) + position(corners[next(edge)]);
  vertices_.push_back(normalised(sum));
  return VertexId{static_cast<std::uint32_t>(vertices_.size() - 1)};
}

void ViewSphere::split(PatchId leaf) {
  ASPECT_CHECK(index_of(leaf) < patches_.size());
  const Patch before = patch(leaf);
  ASPECT_CHECK(!before.split);
  std::array<VertexId, 3> middle{};  // by the corner it lies opposite
  for (std::size_t edge = 0; edge < 3; ++edge) middle[previous(edge)] = midpoint(leaf, edge);

  std::array<PatchId, 4> children{};
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<VertexId, 3> corners{};
    corners[k] = before.corners[k];
    corners[next(k)] = middle[previous(k)];
    corners[previous(k)] = middle[next(k)];
    children[k] = add_patch(corners, before.level + 1, leaf);
  }
  children[kMiddle] = add_patch(middle, before.level + 1, leaf);
  patches_[index_of(leaf)].split = true;
  patches_[index_of(leaf)].children = children;
  link_children(leaf);
}

void ViewSphere::link_children(PatchId parent) {
  const auto link = [this](PatchId a, std::size_t a_edge, PatchId b, std::size_t b_edge) {
    links(a).across[a_edge] = b;
    links(b).across[b_edge] = a;
  };
  const auto& ours = patch(parent).children;
  for (std::size_t k = 0; k < 3; ++k) link(ours[k], next(k), ours[kMiddle], next(k));

  for (std::size_t edge = 0; edge < 3; ++edge) {
    const PatchId other = links(parent).across[edge];
    if (other == kNone || !patch(other).split) continue;
    // The same edge runs the other way round the other patch.
    const std::size_t their_edge = edge_towards(other, parent);
    const auto& theirs = patch(other).children;
    link(ours[edge], edge, theirs[next(their_edge)], their_edge);
    link(ours[next(edge)], edge, theirs[their_edge], their_edge);
  }
}

std::vector<PatchId> ViewSphere::leaves() const {
  std::vector<PatchId> found;
  found.reserve(patches_.size() - patches_.size() / 4 + kRoots);
  for (std::uint32_t root = 0; root < kRoots; ++root) append_leaves(PatchId{root}, found);
  return found;
}

void ViewSphere::append_leaves(PatchId patch_id, std::vector<PatchId>& found) const {
  if (!patch(patch_id).split) {
    found.push_back(patch_id);
    return;
  }
  for (const PatchId child : patch(patch_id).children) append_leaves(child, found);
}

std::vector<PatchId> ViewSphere::neighbours(PatchId leaf) const {
  ASPECT_CHECK(!patch(leaf).split);
  std::vector<PatchId> found;
  for (std::size_t edge = 0; edge < 3; ++edge) {
    // A missing link means that the other side is coarser; inner edges of a split patch and edges
    // of level 0 are always linked, so the way up ends.
    PatchId patch_id = leaf;
    while (links(patch_id).across[edge] == kNone) patch_id = links(patch_id).parent;
    const PatchId other = links(patch_id).across[edge];
    append_along(other, edge_towards(other, patch_id), found);
  }
  return found;
}

// Against the patch's own direction, that is in the direction of the one on the other side.
void ViewSphere::append_along(PatchId patch_id, std::size_t edge,
                              std::vector<PatchId>& found) const {
  if (!patch(patch_id).split) {
    found.push_back(patch_id);
    return;
  }
  append_along(patch(patch_id).children[next(edge)], edge, found);
  append_along(patch(patch_id).children[edge], edge, found);
}

// Van Oosterom and Strackee, "The solid angle of a plane triangle", 1983: the tangent of half the
// area. The triple product is taken of the edges, which are short, and so loses no digits.
double ViewSphere::area_sr(PatchId patch_id) const {
  const auto& corners = patch(patch_id).corners;
  const Eigen::Vector3d& a = position(corners[0]);
  const Eigen::Vector3d& b = position(corners[1]);
  const Eigen::Vector3d& c = position(corners[2]);
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d ac = c - a;
  const double above = dot(a, ab.cross(ac));
  const double below = 1 + dot(a, b) + dot(b, c) + dot(c, a);
  return 2 * arc_tangent(above / below);
}

// The edge, not its far end, for the same reason: a cross product of near parallel vectors loses
// digits.
double ViewSphere::triple_product(VertexId a, VertexId b, const Eigen::Vector3d& c) const {
  const Eigen::Vector3d edge = position(b) - position(a);
  return dot(position(a).cross(edge), c);
}

// The signs at a border are those of rounding errors, and together they may even contradict each
// other. So the root is the one whose worst sign is best, and below it the middle child takes
// whatever no corner claims: there always is an answer, wrong by rounding at most.
PatchId ViewSphere::locate(const Eigen::Vector3d& direction) const {
  ASPECT_CHECK(direction.allFinite() && !direction.isZero(0));
  PatchId here{0};
  double best = -std::numeric_limits<double>::infinity();
  for (std::uint32_t root = 0; root < kRoots; ++root) {
    const auto& corners = patches_[root].corners;
    double worst = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      worst = std::min(worst, triple_product(corners[k], corners[next(k)], direction));
    }
    if (worst > best) {
      best = worst;
      here = PatchId{root};
    }
  }
  while (patch(here).split) {
    const auto& children = patch(here).children;
    const auto& middle = patch(children[kMiddle]).corners;
    std::size_t chosen = kMiddle;
    for (std::size_t k = 0; k < 3; ++k) {
      if (triple_product(middle[next(k)], middle[previous(k)], direction) < 0) chosen = k;
    }
    here = children[chosen];
  }
  return here;
}

}  // namespace aspect
