// What is to be seen are items: points along edges, of faces, surfaces, borders. Each view shows
// some share of each; the view that adds most to what is seen already is taken next (greedy cover:
// within 1 - 1/e of the best choice, Nemhauser et al. 1978).
#include "tools/doctor/finding_views.h"

#include <algorithm>
#include <map>
#include <optional>

#include "tools/aspectc/project/visible_contours.h"
#include "tools/doctor/object_view.h"

namespace aspect {
namespace {

using Eigen::Vector3d;
using Pair = std::pair<std::size_t, std::size_t>;

constexpr int kSide_px = 256;
constexpr std::size_t kMostPoints = 1500;  // of a finding
constexpr double kWorthwhile = 0.06;       // of all weight, that a further view has to add

double weight_of(Severity severity) {
  return severity == Severity::error ? 4 : severity == Severity::warning ? 2 : 0.5;
}

std::vector<Vector3d> points_of(const FindingMarks& marks) {
  std::vector<Vector3d> all = marks.points;
  for (const auto& [a, b] : marks.lines) all.push_back((a + b) / 2);
  for (const auto& face : marks.faces) {
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& corner : face) middle += corner / static_cast<double>(face.size());
    all.push_back(middle);
  }
  if (all.size() <= kMostPoints) return all;
  std::vector<Vector3d> some;
  for (std::size_t k = 0; k < kMostPoints; ++k) some.push_back(all[k * all.size() / kMostPoints]);
  return some;
}

// All that is to be seen.
struct Items {
  std::vector<double> weights;
  std::vector<std::pair<std::size_t, Vector3d>> points;  // item and place
  std::vector<std::vector<std::size_t>> of_primitive;    // items by primitive
  std::multimap<Pair, std::size_t> of_border, of_colours;

  explicit Items(const Diagnosis& diagnosis) : of_primitive(diagnosis.primitives) {
    for (const Finding& finding : diagnosis.findings) add(finding);
  }

  void add(const Finding& finding) {
    const std::size_t first = weights.size();
    const FindingMarks& marks = finding.marks;
    for (const Vector3d& point : points_of(marks)) points.emplace_back(next(), point);
    for (const std::size_t primitive : marks.primitives) of_primitive[primitive].push_back(next());
    for (const Pair& pair : marks.borders) of_border.emplace(pair, next());
    for (const Pair& pair : marks.of_colours) of_colours.emplace(pair, next());
    const auto count = static_cast<double>(weights.size() - first);
    for (std::size_t k = first; k < weights.size(); ++k)
      weights[k] = weight_of(finding.severity) / count;
  }

 private:
  std::size_t next() {
    weights.push_back(0);
    return weights.size() - 1;
  }
};

void count(const std::multimap<Pair, std::size_t>& items, const Pair& key,
           std::vector<double>& seen) {
  if (items.empty()) return;
  const auto [begin, end] = items.equal_range(key);
  for (auto it = begin; it != end; ++it) ++seen[it->second];
}

// By item: 1 of a point that is shown, pixels of all else.
std::vector<double> seen_in(const ObjectView& view, const Items& items,
                            const ColourGroups& groups) {
  std::vector<double> seen(items.weights.size(), 0);
  for (const auto& [item, point] : items.points)
    if (const auto projected = view.project(point); projected && view.shows(*projected))
      seen[item] = 1;
  const std::vector<std::uint16_t>& surface = view.picture().surface;
  const auto width = static_cast<std::size_t>(view.side_px());
  for (std::size_t k = 0; k < surface.size(); ++k) {
    if (surface[k] == 0) continue;
    const std::size_t own = surface[k] - 1U;
    for (const std::size_t item : items.of_primitive[own]) ++seen[item];
    for (const std::size_t next : {k + 1, k + width}) {
      if (next >= surface.size() || (next == k + 1 && next % width == 0)) continue;
      if (surface[next] == 0 || surface[next] == surface[k] || !view.touch(k, next)) continue;
      const std::size_t other = surface[next] - 1U;
      count(items.of_border, Pair(std::minmax(own, other)), seen);
      count(items.of_colours, Pair(std::minmax(groups.group_of[own], groups.group_of[other])),
            seen);
    }
  }
  return seen;
}

// Shares of the most that any view shows.
void scale_to_best(std::vector<std::vector<double>>& seen) {
  for (std::size_t item = 0; item < seen.front().size(); ++item) {
    double best = 0;
    for (const auto& view : seen) best = std::max(best, view[item]);
    for (auto& view : seen) view[item] = best > 0 ? view[item] / best : 0;
  }
}

}  // namespace

std::vector<Vector3d> best_views(const Diagnosis& diagnosis, const ColourGroups& groups,
                                 const Renderer& renderer, const Studio& studio) {
  const Vector3d usual = Vector3d(1, 0.7, 0.5).normalized();
  const Items items(diagnosis);
  if (items.weights.empty()) return {usual};
  const std::vector<Vector3d> directions = examined_directions();
  std::vector<std::vector<double>> seen;
  for (const Vector3d& direction : directions)
    seen.push_back(seen_in(ObjectView(renderer, studio, direction, kSide_px), items, groups));
  scale_to_best(seen);
  double whole = 0;
  for (const double weight : items.weights) whole += weight;
  std::vector<double> covered(items.weights.size(), 0);
  std::vector<Vector3d> chosen;
  while (chosen.size() < kMostViews) {
    std::size_t best = 0;
    double most = -1;
    for (std::size_t view = 0; view < directions.size(); ++view) {
      double gain = 0;
      for (std::size_t item = 0; item < covered.size(); ++item)
        gain += items.weights[item] * std::max(0.0, seen[view][item] - covered[item]);
      if (gain <= most + 1e-9 * whole) continue;
      most = gain;
      best = view;
    }
    if (most < kWorthwhile * whole) break;
    chosen.push_back(directions[best]);
    for (std::size_t item = 0; item < covered.size(); ++item)
      covered[item] = std::max(covered[item], seen[best][item]);
  }
  if (chosen.empty()) chosen.push_back(usual);
  return chosen;
}

}  // namespace aspect
