// Borders of faces sorted by their ends meet; what is left alone is cut at the vertices that lie on
// it and sorted once more; what is then left alone is open unless another face bears it.
#include "tools/doctor/face_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>

#include "compiler/scene/ear_clipping.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

constexpr double kMostWork = 1e8;  // comparisons: about a second

std::vector<BorderPiece> borders_of(const FaceSet& set, const std::vector<bool>& kept) {
  std::vector<BorderPiece> borders;
  borders.reserve(set.corners.size());
  for (std::uint32_t face = 0; face < set.faces.size(); ++face) {
    if (!kept[face]) continue;
    const auto corners = set.corners_of(face);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::uint32_t a = corners[k], b = corners[(k + 1) % corners.size()];
      if (a != b) borders.push_back({std::min(a, b), std::max(a, b), face, a < b});
    }
  }
  return borders;
}

// What one face alone has goes to `single`.
void join(std::vector<BorderPiece>& pieces, FaceEdges& edges, std::vector<BorderPiece>& single) {
  std::sort(pieces.begin(), pieces.end(), [](const BorderPiece& a, const BorderPiece& b) {
    return std::tie(a.from, a.to, a.face, a.forward) < std::tie(b.from, b.to, b.face, b.forward);
  });
  for (std::size_t begin = 0, end = 0; begin < pieces.size(); begin = end) {
    const BorderPiece& first = pieces[begin];
    while (end < pieces.size() && pieces[end].from == first.from && pieces[end].to == first.to)
      ++end;
    if (end - begin == 1) single.push_back(first);
    if (end - begin > 2) edges.crowded.push_back(first);
    // The slit that joins a hole to the border is a face's own affair.
    if (end - begin == 2 && first.face != pieces[begin + 1].face)
      edges.links.push_back(
          {first.face, pieces[begin + 1].face, first.forward != pieces[begin + 1].forward});
  }
}

// The vertices at the ends of pieces, along the longest side of their box.
class VerticesAlong {
 public:
  VerticesAlong(const FaceSet& set, const std::vector<BorderPiece>& pieces) : set_(set) {
    Eigen::AlignedBox3d box;
    for (const BorderPiece& piece : pieces)
      for (const std::uint32_t end : {piece.from, piece.to}) {
        vertices_.push_back(end);
        box.extend(set.vertices[end]);
      }
    if (!box.isEmpty()) box.sizes().maxCoeff(&axis_);
    std::sort(vertices_.begin(), vertices_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(at(a), a) < std::pair(at(b), b);
    });
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  }

  double work(const BorderPiece& piece) const {
    const auto [begin, end] = range(piece);
    return static_cast<double>(end - begin);
  }

  // Those inside the piece, from one end to the other.
  std::vector<std::uint32_t> on(const BorderPiece& piece) const {
    const Vector3d origin = set_.vertices[piece.from];
    const Vector3d way = set_.vertices[piece.to] - origin;
    std::vector<std::pair<double, std::uint32_t>> found;
    const auto [begin, end] = range(piece);
    for (auto it = begin; it != end; ++it) {
      if (*it == piece.from || *it == piece.to) continue;
      const Vector3d offset = set_.vertices[*it] - origin;
      const double share = offset.dot(way) / way.squaredNorm();
      if (share <= 0 || share >= 1 || (offset - share * way).norm() > 2 * set_.tolerance) continue;
      found.emplace_back(share, *it);
    }
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> vertices;
    for (const auto& [share, vertex] : found) vertices.push_back(vertex);
    return vertices;
  }

 private:
  using Position = std::vector<std::uint32_t>::const_iterator;

  double at(std::uint32_t vertex) const { return set_.vertices[vertex][axis_]; }
  std::pair<Position, Position> range(const BorderPiece& piece) const {
    const auto [least, most] = std::minmax({at(piece.from), at(piece.to)});
    const auto before = [&](std::uint32_t vertex, double value) { return at(vertex) < value; };
    const Position begin =
        std::lower_bound(vertices_.begin(), vertices_.end(), least - 2 * set_.tolerance, before);
    return {begin, std::lower_bound(begin, vertices_.end(), most + 2 * set_.tolerance, before)};
  }

  const FaceSet& set_;
  Eigen::Index axis_ = 0;
  std::vector<std::uint32_t> vertices_;
};

std::vector<BorderPiece> cut(const FaceSet& set, const std::vector<BorderPiece>& pieces) {
  const VerticesAlong vertices(set, pieces);
  double work = 0;
  for (const BorderPiece& piece : pieces) work += vertices.work(piece);
  if (work > kMostWork) return pieces;
  std::vector<BorderPiece> parts;
  for (const BorderPiece& piece : pieces) {
    std::uint32_t last = piece.from;
    std::vector<std::uint32_t> stops = vertices.on(piece);
    stops.push_back(piece.to);
    for (const std::uint32_t stop : stops) {
      const bool upwards = last < stop;
      parts.push_back({std::min(last, stop), std::max(last, stop), piece.face,
                       upwards ? piece.forward : !piece.forward});
      last = stop;
    }
  }
  return parts;
}

// Whether a point lies in a face or on its border.
bool bears(const FaceSet& set, std::size_t face, const Vector3d& normal, const Vector3d& point) {
  const auto corners = set.corners_of(face);
  const double close = 4 * set.tolerance;
  if (std::abs(normal.dot(point - set.vertices[corners[0]])) > close) return false;
  Eigen::Index drop = 0;
  normal.cwiseAbs().maxCoeff(&drop);
  const Eigen::Index x = (drop + 1) % 3, y = (drop + 2) % 3;
  bool inside = false;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector3d& a = set.vertices[corners[k]];
    const Vector3d& b = set.vertices[corners[(k + 1) % corners.size()]];
    const Vector3d way = b - a;
    const double share = std::clamp((point - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
    if ((point - a - share * way).norm() <= close) return true;
    if ((a[y] > point[y]) == (b[y] > point[y])) continue;
    if (point[x] < a[x] + (point[y] - a[y]) / (b[y] - a[y]) * (b[x] - a[x])) inside = !inside;
  }
  return inside;
}

// Moves the open pieces that stand on a face.
void part_borne(const FaceSet& set, const std::vector<bool>& kept, FaceEdges& edges) {
  std::vector<BorderPiece>& open = edges.open;
  if (static_cast<double>(open.size()) * static_cast<double>(set.faces.size()) > kMostWork) return;
  std::vector<bool> borne(open.size(), false);
  std::vector<Vector3d> polygon;
  for (std::size_t face = 0; face < set.faces.size(); ++face) {
    if (!kept[face]) continue;
    polygon.clear();
    Eigen::AlignedBox3d box;
    for (const std::uint32_t corner : set.corners_of(face)) {
      polygon.push_back(set.vertices[corner]);
      box.extend(polygon.back());
    }
    const Vector3d margin = Vector3d::Constant(4 * set.tolerance);
    box = Eigen::AlignedBox3d(box.min() - margin, box.max() + margin);
    const Vector3d normal = polygon_normal(polygon);
    for (std::size_t k = 0; k < open.size(); ++k) {
      const Vector3d &a = set.vertices[open[k].from], &b = set.vertices[open[k].to];
      if (borne[k] || open[k].face == face || !box.contains((a + b) / 2)) continue;
      borne[k] = bears(set, face, normal, (a + b) / 2) &&
                 bears(set, face, normal, (3 * a + b) / 4) &&
                 bears(set, face, normal, (a + 3 * b) / 4);
    }
  }
  std::size_t left = 0;
  for (std::size_t k = 0; k < open.size(); ++k) {
    if (borne[k])
      edges.borne.push_back(open[k]);
    else
      open[left++] = open[k];
  }
  open.resize(left);
}

}  // namespace

FaceEdges face_edges(const FaceSet& set, const std::vector<bool>& kept) {
  FaceEdges edges;
  std::vector<BorderPiece> pieces = borders_of(set, kept);
  std::vector<BorderPiece> single;
  join(pieces, edges, single);
  pieces = cut(set, single);
  join(pieces, edges, edges.open);
  part_borne(set, kept, edges);
  return edges;
}

}  // namespace aspect
