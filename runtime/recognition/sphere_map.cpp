// Idea: corners are not stored but follow from the way down: a midpoint is the normalised sum of
// the ends of its edge. Every formula is the one by which the sphere was divided, spelled out in
// the same order, so that a direction lies in the same patch here and there. Weak side: a root is
// found by trying all 20.
#include "runtime/recognition/sphere_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace aspect {
namespace {

using Format = SphereMapFormat;

constexpr std::size_t kMiddle = 3;  // place of the middle one among the children
// Three times what fits into the most bytes that the compiler spends on a map.
constexpr std::size_t kMostPatches = 1U << 18U;

constexpr std::size_t next(std::size_t corner) {
  return (corner + 1) % 3;
}
constexpr std::size_t previous(std::size_t corner) {
  return (corner + 2) % 3;
}

Vector3d normalised(const Vector3d& v) {
  const double length = norm(v);
  return {v[0] / length, v[1] / length, v[2] / length};
}

// A pole, the five vertices around it, and the antipodes of all six.
std::array<Vector3d, 12> icosahedron_vertices() {
  constexpr double kPhi = std::numbers::phi;
  constexpr Vector3d kPole{0, 1, kPhi};
  constexpr std::array<Vector3d, 5> kRing{
      {{0, -1, kPhi}, {kPhi, 0, 1}, {1, kPhi, 0}, {-1, kPhi, 0}, {-kPhi, 0, 1}}};
  std::array<Vector3d, 12> vertices{};
  vertices[0] = normalised(kPole);
  for (std::size_t k = 0; k < 5; ++k) {
    vertices[1 + k] = normalised(kRing[k]);
    vertices[6 + k] = normalised(Vector3d{} - kRing[(k + 3) % 5]);
  }
  vertices[11] = normalised(Vector3d{} - kPole);
  return vertices;
}

constexpr std::array<std::size_t, 3> root_vertices(std::size_t root) {
  const std::size_t k = root / 4, after = (k + 1) % 5;
  const std::size_t upper = 1 + k, upper_after = 1 + after, lower = 6 + k, lower_after = 6 + after;
  switch (root % 4) {
    case 0:
      return {0, upper, upper_after};
    case 1:
      return {upper, lower, upper_after};
    case 2:
      return {lower, lower_after, upper_after};
    default:
      return {11, lower_after, lower};
  }
}

SphereMap::Corners root_corners(const std::array<Vector3d, 12>& vertices, std::size_t root) {
  const auto [a, b, c] = root_vertices(root);
  return {vertices[a], vertices[b], vertices[c]};
}

// By the corner that they lie opposite: the corners of the middle child.
SphereMap::Corners midpoints(const SphereMap::Corners& corners) {
  SphereMap::Corners middle;
  for (std::size_t edge = 0; edge < 3; ++edge)
    middle[previous(edge)] = normalised(corners[edge] + corners[next(edge)]);
  return middle;
}

SphereMap::Corners child_corners(const SphereMap::Corners& corners,
                                 const SphereMap::Corners& middle, std::size_t child) {
  if (child == kMiddle) return middle;
  SphereMap::Corners found;
  found[child] = corners[child];
  found[next(child)] = middle[previous(child)];
  found[previous(child)] = middle[next(child)];
  return found;
}

double triple_product(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  return dot(cross(a, b - a), c);
}

struct Point {
  double x = 0, y = 0;
};
Point operator-(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y};
}
double cross(const Point& a, const Point& b) {
  return a.x * b.y - a.y * b.x;
}

// The flat triangle that stands for every patch.
constexpr std::array<Point, 4> kFlat{{{0, 0}, {1, 0}, {0, 1}, {0, 0}}};

Point flat_point(const SphereMap::Corners& corners, const Vector3d& direction) {
  std::array<double, 3> weights{};
  for (std::size_t k = 0; k < 3; ++k)
    weights[k] = triple_product(corners[next(k)], corners[previous(k)], direction);
  const double sum = weights[0] + weights[1] + weights[2];
  return {weights[1] / sum, weights[2] / sum};
}

Point point_at(int place) {
  const auto edge = static_cast<std::size_t>(place / Format::kSteps);
  const double share = static_cast<double>(place % Format::kSteps) / Format::kSteps;
  const Point &a = kFlat[edge], &b = kFlat[edge + 1];
  return {(1 - share) * a.x + share * b.x, (1 - share) * a.y + share * b.y};
}

// The middle of the places; where all lie on one edge, moved towards the middle of the patch.
Point middle_of(const SphereMap::Division& division) {
  Point sum;
  for (std::size_t k = 0; k < division.count; ++k) {
    const Point point = point_at(division.places[k]);
    sum = {sum.x + point.x, sum.y + point.y};
  }
  const Point mean{sum.x / division.count, sum.y / division.count};
  const int first = division.places[0], last = division.places[division.count - 1U];
  if (first / Format::kSteps != last / Format::kSteps) return mean;
  return {(mean.x + 1.0 / 3) / 2, (mean.y + 1.0 / 3) / 2};
}

// The place, in edges, where the ray from `from` through `to` leaves the triangle.
double exit_place(const Point& from, const Point& to) {
  const Point along = to - from;
  double best = 0, least = std::numeric_limits<double>::infinity();
  for (std::size_t edge = 0; edge < 3; ++edge) {
    const Point side = kFlat[edge + 1] - kFlat[edge];
    const double below = cross(along, side);
    if (!(below > 0)) continue;  // a ray leaves counter-clockwise triangles with edges to its left
    const double distance = cross(kFlat[edge] - from, side) / below;
    if (distance >= least) continue;
    least = distance;
    const double share = cross(kFlat[edge] - from, along) / below;
    best = static_cast<double>(edge) + std::clamp(share, 0.0, 1.0);
  }
  return best >= 3 ? 0 : best;
}

std::int32_t class_in(const SphereMap::Division& division, const Point& point) {
  const double place = exit_place(middle_of(division), point) * Format::kSteps;
  std::size_t piece = division.count - 1U;  // from the last place on, and round to the first
  for (std::size_t k = 0; k < division.count && division.places[k] <= place; ++k) piece = k;
  return division.classes[piece];
}

}  // namespace

// Members: what members are made of must not be without a name outside when sources are joined.
class SphereMap::BitReader {
 public:
  explicit BitReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint32_t get(int bits) {
    std::uint32_t value = 0;
    for (int bit = 0; bit < bits; ++bit, ++used_) {
      failed = failed || used_ / 8 >= bytes_.size();
      const std::uint32_t byte = failed ? 0U : bytes_[used_ / 8];
      value = value << 1U | ((byte >> (7 - used_ % 8)) & 1U);
    }
    return value;
  }
  bool failed = false;

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t used_ = 0;
};

struct SphereMap::Decoder {
  SphereMap& map;
  BitReader in;
  std::size_t class_count;
  int bits = Format::class_bits(class_count);
  std::int32_t last = kNone;

  void get(std::size_t place, int level) {
    if (in.failed) return;
    if (in.get(1) == 1) return split(place, level);
    const bool same = in.get(1) == 1;
    const bool divided = !same && in.get(1) == 1;
    if (divided) return get_division(place);
    if (!same) last = get_class();
    map.patches_[place] = {Patch::kWhole, static_cast<std::uint32_t>(last + 1) & kNumberMask};
  }

  void split(std::size_t place, int level) {
    const std::size_t first = map.patches_.size();
    in.failed = in.failed || level >= Format::kDeepestLevel || first > kMostPatches;
    if (in.failed) return;
    map.patches_.resize(first + 4);
    map.patches_[place] = {Patch::kSplit, static_cast<std::uint32_t>(first) & kNumberMask};
    for (std::size_t child = 0; child < 4; ++child) get(first + child, level + 1);
    const auto is_blind = [](const Patch& patch) {
      return patch.kind == Patch::kBlind || (patch.kind == Patch::kWhole && patch.number == 0);
    };
    const auto children = std::span(map.patches_).subspan(first, 4);
    if (std::all_of(children.begin(), children.end(), is_blind))
      map.patches_[place].kind = Patch::kBlind;
  }

  std::int32_t get_class() {
    const auto id = static_cast<std::int32_t>(in.get(bits)) - 1;
    in.failed = in.failed || id >= static_cast<std::int32_t>(class_count);
    return in.failed ? kNone : id;
  }

  void get_division(std::size_t place) {
    Division division;
    division.count = static_cast<std::uint8_t>(in.get(Format::kPieceBits) + Format::kFewestPieces);
    for (std::size_t k = 0; k < division.count && !in.failed; ++k) {
      division.places[k] = static_cast<std::uint8_t>(in.get(Format::kPlaceBits));
      in.failed = in.failed || division.places[k] >= 3 * Format::kSteps ||
                  (k > 0 && division.places[k] <= division.places[k - 1]);
      division.classes[k] = get_class();
    }
    map.patches_[place] = {Patch::kDivided,
                           static_cast<std::uint32_t>(map.divisions_.size()) & kNumberMask};
    map.divisions_.push_back(division);
  }

  static constexpr std::uint32_t kNumberMask = (1U << 30U) - 1;
};

Result<SphereMap> SphereMap::decode(std::span<const std::uint8_t> bytes, std::size_t class_count) {
  SphereMap map;
  map.vertices_ = icosahedron_vertices();
  map.patches_.resize(Format::kRoots);
  Decoder decoder{map, BitReader(bytes), class_count};
  for (std::size_t root = 0; root < Format::kRoots; ++root) decoder.get(root, 0);
  if (decoder.in.failed)
    return Error{"its map of the viewing sphere is damaged; compile the scene again"};
  return map;
}

// At a border signs are those of rounding errors: the root is the one whose worst sign is best, and
// below it the middle child takes what no corner claims.
std::int32_t SphereMap::class_at(const Vector3d& direction) const noexcept {
  if (patches_.empty()) return kNone;
  std::size_t place = 0;
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t root = 0; root < Format::kRoots; ++root) {
    const Corners corners = root_corners(vertices_, root);
    double worst = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k)
      worst = std::min(worst, triple_product(corners[k], corners[next(k)], direction));
    if (!(worst > best)) continue;
    best = worst;
    place = root;
  }
  Corners corners = root_corners(vertices_, place);
  while (patches_[place].kind == Patch::kSplit) {
    const Corners middle = midpoints(corners);
    std::size_t chosen = kMiddle;
    for (std::size_t k = 0; k < 3; ++k)
      if (triple_product(middle[next(k)], middle[previous(k)], direction) < 0) chosen = k;
    corners = child_corners(corners, middle, chosen);
    place = patches_[place].number + chosen;
  }
  if (patches_[place].kind == Patch::kBlind) return kNone;
  if (patches_[place].kind == Patch::kWhole)
    return static_cast<std::int32_t>(patches_[place].number) - 1;
  return class_in(divisions_[patches_[place].number], flat_point(corners, direction));
}

// The children nearest to the direction come first, and those that cannot hold a nearer view than
// the best one so far are left out: a patch lies within a ball about its centre, through its
// farthest corner.
struct SphereMap::Search {
  const SphereMap& map;
  Vector3d direction;
  double corner = -2, centre = -2;                            // cosines
  double distance = std::numeric_limits<double>::infinity();  // of the corner
  std::int32_t class_id = kNone;

  struct Branch {
    std::uint32_t patch = 0;
    Corners corners{};
    Vector3d middle{};
    double least_distance = 0;
  };

  Branch branch(std::uint32_t patch, const Corners& corners) const {
    const Vector3d middle = normalised(corners[0] + corners[1] + corners[2]);
    double radius = 0;
    for (const Vector3d& c : corners) radius = std::max(radius, norm(c - middle));
    return {patch, corners, middle, norm(direction - middle) - radius};
  }

  void visit(const Branch& branch) {
    constexpr double kRounding = 1e-9;
    if (branch.least_distance > distance + kRounding) return;
    const Patch& patch = map.patches_[branch.patch];
    if (patch.kind == Patch::kWhole && patch.number > 0) take(branch);
    if (patch.kind == Patch::kSplit) descend(patch.number, branch.corners);
  }

  void take(const Branch& branch) {
    double nearest = -2, nearest_distance = distance;
    for (const Vector3d& c : branch.corners) {
      nearest = std::max(nearest, dot(c, direction));
      nearest_distance = std::min(nearest_distance, norm(direction - c));
    }
    const double middle = dot(branch.middle, direction);
    if (nearest < corner || (nearest == corner && middle <= centre)) return;
    corner = nearest;
    centre = middle;
    distance = nearest_distance;
    class_id = static_cast<std::int32_t>(map.patches_[branch.patch].number) - 1;
  }

  void descend(std::uint32_t first, const Corners& corners) {
    const Corners middle = midpoints(corners);
    std::array<Branch, 4> branches;
    for (std::uint32_t child = 0; child < 4; ++child)
      branches[child] = branch(first + child, child_corners(corners, middle, child));
    visit_in_order(branches);
  }

  template <std::size_t count>
  void visit_in_order(std::array<Branch, count>& branches) {
    std::sort(branches.begin(), branches.end(), [](const Branch& a, const Branch& b) {
      if (a.least_distance != b.least_distance) return a.least_distance < b.least_distance;
      return a.patch < b.patch;
    });
    for (const Branch& next_nearest : branches) visit(next_nearest);
  }
};

std::int32_t SphereMap::nearest_class(const Vector3d& direction_unit) const noexcept {
  if (patches_.empty()) return kNone;
  Search search{*this, direction_unit};
  std::array<Search::Branch, Format::kRoots> roots;
  for (std::uint32_t root = 0; root < Format::kRoots; ++root)
    roots[root] = search.branch(root, root_corners(vertices_, root));
  search.visit_in_order(roots);
  return search.class_id;
}

std::vector<SphereMap::Leaf> SphereMap::leaves() const {
  std::vector<Leaf> found;
  if (patches_.empty()) return found;
  for (std::uint32_t root = 0; root < Format::kRoots; ++root)
    append_leaves(root, root_corners(vertices_, root), found);
  return found;
}

void SphereMap::append_leaves(std::uint32_t patch, const Corners& corners,
                              std::vector<Leaf>& found) const {
  const std::uint32_t number = patches_[patch].number;
  switch (patches_[patch].kind) {
    case Patch::kWhole:
      found.push_back({corners, static_cast<std::int32_t>(number) - 1, nullptr});
      return;
    case Patch::kDivided:
      found.push_back({corners, kNone, &divisions_[number]});
      return;
    default:
      const Corners middle = midpoints(corners);
      for (std::uint32_t child = 0; child < 4; ++child)
        append_leaves(number + child, child_corners(corners, middle, child), found);
  }
}

}  // namespace aspect
