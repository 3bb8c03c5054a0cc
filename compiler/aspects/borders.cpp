#include "compiler/aspects/borders.h"

#include <algorithm>

namespace aspect {
namespace {

// A piece of an edge whose ends do not match.
struct Gap {
  std::uint64_t edge = 0;
  EdgeView begin, end;
};

std::vector<Gap> first_gaps(const CompileOptions& options, const Subdivision& found) {
  std::vector<Gap> gaps;
  std::unordered_set<std::uint64_t> met;
  for (const PatchId id : found.sphere.leaves()) {
    const Patch& patch = found.sphere.patch(id);
    if (is_uniform(found, patch, options.cluster_threshold)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(patch.corners[k], patch.corners[(k + 1) % 3]);
      if (found.matches.cost(low, high) <= options.cluster_threshold) continue;
      if (found.views[number(low)].external_count == 0 ||
          found.views[number(high)].external_count == 0)
        continue;
      const std::uint64_t edge = pair_key(low, high);
      if (met.insert(edge).second) gaps.push_back({edge, {0, low}, {1, high}});
    }
  }
  return gaps;
}

// The views halfway along the gaps.
std::vector<Observations::Wanted> middles(const std::vector<Gap>& gaps, const Subdivision& found) {
  std::vector<Observations::Wanted> wanted;
  auto next = static_cast<std::uint32_t>(found.views.size());
  for (const Gap& gap : gaps) {
    const Eigen::Vector3d sum = found.direction(gap.begin.view) + found.direction(gap.end.view);
    wanted.push_back({static_cast<VertexId>(next++), sum.normalized()});
  }
  return wanted;
}

}  // namespace

Result<Done> find_borders(const CompileOptions& options, Subdivision& found,
                          Observations& observations) {
  std::vector<Gap> gaps = first_gaps(options, found);
  // Every round takes about as many views as the first. Thin aspects between two others add some,
  // seldom more than a quarter.
  const auto most = static_cast<std::size_t>(options.border_views);
  if (gaps.size() * kBisections > most) return Done{};
  std::size_t spent = 0;
  for (int round = 0; round < kBisections; ++round) {
    spent += gaps.size();
    if (spent > 2 * most) break;
    observations.progress.border_round = round + 1;
    const std::vector<Observations::Wanted> wanted = middles(gaps, found);
    if (Result<Done> done = observations.observe(wanted); !done) return done;
    std::vector<ViewPair> pairs;
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      pairs.emplace_back(gaps[i].begin.view, wanted[i].view);
      pairs.emplace_back(wanted[i].view, gaps[i].end.view);
    }
    if (Result<Done> done = observations.match(pairs); !done) return done;
    std::vector<Gap> narrower;
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      const Gap& gap = gaps[i];
      const EdgeView middle{(gap.begin.place + gap.end.place) / 2, wanted[i].view};
      found.edge_views[gap.edge].push_back(middle);
      for (const Gap& half : {Gap{gap.edge, gap.begin, middle}, Gap{gap.edge, middle, gap.end}})
        if (found.matches.cost(half.begin.view, half.end.view) > options.cluster_threshold)
          narrower.push_back(half);
    }
    gaps = std::move(narrower);
  }
  for (auto& [edge, views] : found.edge_views)
    std::sort(views.begin(), views.end(),
              [](const EdgeView& a, const EdgeView& b) { return a.place < b.place; });
  return Done{};
}

}  // namespace aspect
