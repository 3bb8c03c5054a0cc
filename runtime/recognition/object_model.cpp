#include "runtime/recognition/object_model.h"

#include <algorithm>
#include <cmath>

namespace aspect {
namespace {

std::array<float, 3> shares_of(const std::array<std::uint8_t, 3>& paint) {
  const float sum = static_cast<float>(paint[0] + paint[1] + paint[2]);
  if (sum == 0) return {1.0F / 3, 1.0F / 3, 1.0F / 3};
  return {static_cast<float>(paint[0]) / sum, static_cast<float>(paint[1]) / sum,
          static_cast<float>(paint[2]) / sum};
}

bool alike(const std::array<float, 3>& a, const std::array<float, 3>& b, float step) {
  return std::abs(a[0] - b[0]) <= step && std::abs(a[1] - b[1]) <= step &&
         std::abs(a[2] - b[2]) <= step;
}

// Of each paint; fills the shares of the classes.
std::vector<ColourClass> classes_of(const PaintedModel& painted, float step, int intensity_min,
                                    std::vector<std::array<float, 3>>& class_shares) {
  const std::size_t count = painted.paints.size();
  std::vector<ColourClass> classes(count, kBackgroundClass);
  for (std::size_t k = 0; k < count; ++k) {
    const auto& paint = painted.paints[k];
    if (classes[k] != kBackgroundClass || paint[0] + paint[1] + paint[2] < intensity_min) continue;
    class_shares.push_back(shares_of(paint));
    const auto own = static_cast<ColourClass>(class_shares.size());
    std::vector<std::size_t> waiting{k};
    classes[k] = own;
    while (!waiting.empty()) {
      const auto from = shares_of(painted.paints[waiting.back()]);
      waiting.pop_back();
      for (std::size_t other = 0; other < count; ++other) {
        const auto& p = painted.paints[other];
        if (classes[other] != kBackgroundClass || p[0] + p[1] + p[2] < intensity_min ||
            !alike(from, shares_of(p), step))
          continue;
        classes[other] = own;
        waiting.push_back(other);
      }
    }
  }
  return classes;
}

struct HalfEdge {
  std::uint16_t low = 0, high = 0, opposite = 0;
  ColourClass colour = kBackgroundClass;
};

// Distance of a point from the plane of an edge and a third point, as a share of the model.
bool is_flat(const ObjectModel& model, const HalfEdge& a, const HalfEdge& b) {
  const Vector3d& origin = model.vertices[a.low];
  const Vector3d along = model.vertices[a.high] - origin;
  const Vector3d normal = cross(along, model.vertices[a.opposite] - origin);
  const double length = norm(normal);
  constexpr double kFlat = 1e-3;
  if (length == 0) return true;
  return std::abs(dot(normal, model.vertices[b.opposite] - origin)) <=
         kFlat * model.radius * length;
}

std::vector<ModelEdge> edges_of(const ObjectModel& model) {
  std::vector<HalfEdge> halves;
  for (const ModelTriangle& t : model.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(t.corners[k], t.corners[(k + 1) % 3]);
      halves.push_back({low, high, t.corners[(k + 2) % 3], t.colour});
    }
  std::sort(halves.begin(), halves.end(), [](const HalfEdge& a, const HalfEdge& b) {
    if (a.low != b.low) return a.low < b.low;
    if (a.high != b.high) return a.high < b.high;
    return a.opposite < b.opposite;
  });
  std::vector<ModelEdge> edges;
  for (std::size_t first = 0; first < halves.size();) {
    std::size_t end = first + 1;
    while (end < halves.size() && halves[end].low == halves[first].low &&
           halves[end].high == halves[first].high)
      ++end;
    const HalfEdge& a = halves[first];
    if (end - first == 2) {
      const HalfEdge& b = halves[first + 1];
      if (a.colour != b.colour || !is_flat(model, a, b))
        edges.push_back({{a.low, a.high}, {a.opposite, b.opposite}, {a.colour, b.colour}});
    } else {
      for (std::size_t k = first; k < end; ++k)
        edges.push_back({{a.low, a.high},
                         {halves[k].opposite, halves[k].opposite},
                         {halves[k].colour, halves[k].colour}});
    }
    first = end;
  }
  return edges;
}

}  // namespace

ObjectModel prepared_model(const PaintedModel& painted, int chroma_step, int intensity_min) {
  ObjectModel model;
  model.vertices = painted.vertices;
  model.paints = painted.paints;
  const std::vector<ColourClass> classes =
      classes_of(painted, static_cast<float>(chroma_step) / 255, intensity_min, model.shares);
  for (const PaintedModel::Triangle& t : painted.triangles)
    model.triangles.push_back({t.corners, classes[t.paint], t.paint});
  Vector3d least{}, most{};
  for (std::size_t k = 0; k < model.vertices.size(); ++k)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = model.vertices[k][axis];
      least[axis] = k == 0 ? x : std::min(least[axis], x);
      most[axis] = k == 0 ? x : std::max(most[axis], x);
    }
  model.radius = norm(most - least) / 2;
  model.edges = edges_of(model);
  return model;
}

}  // namespace aspect
