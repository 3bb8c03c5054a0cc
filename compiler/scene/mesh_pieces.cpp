#include "compiler/scene/mesh_pieces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "compiler/scene/flat_piece.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

bool has_area(const std::vector<Vector3d>& vertices, const SurfaceTriangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  if (a == b || b == c || c == a) return false;
  return !(vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]).isZero(0);
}

std::array<std::uint32_t, 4> sorted_key(const SurfaceTriangle& triangle) {
  std::array<std::uint32_t, 3> corners = triangle.corners;
  std::sort(corners.begin(), corners.end());
  return {corners[0], corners[1], corners[2], triangle.surface};
}

void leave_out_repeated(std::vector<SurfaceTriangle>& triangles) {
  std::vector<std::pair<std::array<std::uint32_t, 4>, std::uint32_t>> keys;
  for (std::uint32_t k = 0; k < triangles.size(); ++k)
    keys.emplace_back(sorted_key(triangles[k]), k);
  std::sort(keys.begin(), keys.end());
  std::vector<bool> repeated(triangles.size(), false);
  for (std::size_t k = 1; k < keys.size(); ++k)
    if (keys[k].first == keys[k - 1].first) repeated[keys[k].second] = true;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < triangles.size(); ++k)
    if (!repeated[k]) triangles[kept++] = triangles[k];
  triangles.resize(kept);
}

// The least triangle of every piece stands for it.
class Union {
 public:
  explicit Union(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t find(std::uint32_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t first = find(a), second = find(b);
    parent_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

std::tuple<double, double, double> place(const Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

// The vertex at a place, of those that triangles use.
class VertexFinder {
 public:
  VertexFinder(const std::vector<Vector3d>& vertices, const std::vector<SurfaceTriangle>& triangles)
      : vertices_(vertices) {
    for (const SurfaceTriangle& triangle : triangles)
      used_.insert(used_.end(), triangle.corners.begin(), triangle.corners.end());
    std::sort(used_.begin(), used_.end());
    used_.erase(std::unique(used_.begin(), used_.end()), used_.end());
    std::sort(used_.begin(), used_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return place(vertices[a]) < place(vertices[b]);
    });
  }
  std::uint32_t at(const Vector3d& point) const {
    const auto found = std::lower_bound(
        used_.begin(), used_.end(), place(point),
        [&](std::uint32_t k, const auto& wanted) { return place(vertices_[k]) < wanted; });
    return found != used_.end() && place(vertices_[*found]) == place(point) ? *found : kNone;
  }

 private:
  const std::vector<Vector3d>& vertices_;
  std::vector<std::uint32_t> used_;
};

struct Edge {
  std::uint32_t from, to, surface, triangle;
  auto operator<=>(const Edge&) const = default;
};

// The edge, or the pieces it is cut into by vertices at its middle, at theirs, and so on.
void add_cut(const std::vector<Vector3d>& vertices, const VertexFinder& finder, const Edge& whole,
             std::vector<Edge>& edges) {
  std::vector<Edge> open = {whole};
  while (!open.empty()) {
    const Edge edge = open.back();
    open.pop_back();
    const std::uint32_t middle = finder.at((vertices[edge.from] + vertices[edge.to]) / 2);
    if (middle == kNone || middle == edge.from || middle == edge.to) {
      edges.push_back(edge);
      continue;
    }
    for (const std::uint32_t end : {edge.from, edge.to})
      open.push_back({std::min(end, middle), std::max(end, middle), edge.surface, edge.triangle});
  }
}

}  // namespace

void weld(std::vector<Vector3d>& vertices, std::vector<SurfaceTriangle>& triangles) {
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple(place(vertices[a]), a) < std::tuple(place(vertices[b]), b);
  });
  std::vector<std::uint32_t> first(vertices.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool same = k > 0 && place(vertices[order[k]]) == place(vertices[order[k - 1]]);
    first[order[k]] = same ? first[order[k - 1]] : order[k];
  }
  for (SurfaceTriangle& triangle : triangles)
    for (std::uint32_t& corner : triangle.corners) corner = first[corner];
  std::erase_if(triangles, [&](const SurfaceTriangle& t) { return !has_area(vertices, t); });
  leave_out_repeated(triangles);
}

std::vector<std::uint32_t> pieces_by_edges(const std::vector<Vector3d>& vertices,
                                           const std::vector<SurfaceTriangle>& triangles) {
  const VertexFinder finder(vertices, triangles);
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t].corners[k], b = triangles[t].corners[(k + 1) % 3];
      add_cut(vertices, finder, {std::min(a, b), std::max(a, b), triangles[t].surface, t}, edges);
    }
  std::sort(edges.begin(), edges.end());
  Union joined(triangles.size());
  for (std::size_t k = 1; k < edges.size(); ++k) {
    const Edge &a = edges[k - 1], &b = edges[k];
    if (a.from == b.from && a.to == b.to && a.surface == b.surface)
      joined.join(a.triangle, b.triangle);
  }
  std::vector<std::uint32_t> pieces(triangles.size());
  std::uint32_t count = 0;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const std::uint32_t first = joined.find(t);
    pieces[t] = first == t ? count++ : pieces[first];
  }
  return pieces;
}

std::vector<std::uint32_t> pieces_by_surface(const std::vector<SurfaceTriangle>& triangles) {
  std::unordered_map<std::uint32_t, std::uint32_t> piece_of_surface;
  std::vector<std::uint32_t> pieces;
  for (const SurfaceTriangle& triangle : triangles)
    pieces.push_back(
        piece_of_surface
            .try_emplace(triangle.surface, static_cast<std::uint32_t>(piece_of_surface.size()))
            .first->second);
  return pieces;
}

std::vector<Primitive> primitives_of(const std::vector<Vector3d>& vertices,
                                     const std::vector<SurfaceTriangle>& triangles,
                                     const std::vector<std::uint32_t>& piece_of) {
  const std::size_t count =
      piece_of.empty() ? 0 : *std::max_element(piece_of.begin(), piece_of.end()) + std::size_t{1};
  std::vector<std::vector<std::uint32_t>> members(count);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) members[piece_of[t]].push_back(t);

  std::vector<Primitive> primitives;
  std::vector<std::uint32_t> local(vertices.size(), kNone);
  for (const std::vector<std::uint32_t>& piece : members) {
    Mesh mesh;
    std::vector<std::uint32_t> used;
    for (const std::uint32_t t : piece) {
      std::array<std::uint32_t, 3> triangle = triangles[t].corners;
      for (std::uint32_t& corner : triangle) {
        if (local[corner] == kNone) {
          local[corner] = static_cast<std::uint32_t>(used.size());
          used.push_back(corner);
          mesh.vertices.push_back(vertices[corner]);
        }
        corner = local[corner];
      }
      mesh.triangles.push_back(triangle);
    }
    for (const std::uint32_t corner : used) local[corner] = kNone;
    const auto surface = static_cast<int>(triangles[piece.front()].surface);
    if (std::optional<Polygon> polygon = as_polygon(mesh))
      primitives.push_back({std::move(*polygon), surface});
    else
      primitives.push_back({std::move(mesh), surface});
  }
  return primitives;
}

}  // namespace aspect
