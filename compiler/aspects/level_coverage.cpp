// The sphere is built again level by level: what the subdivision has split is split, in the order
// that it has them, so that vertices get the numbers that they have there.
#include "compiler/aspects/level_coverage.h"

#include <algorithm>

namespace aspect {
namespace {

constexpr int kFirstLevel = 2;

// Sees to it that the sides of a patch are matched, and counts those that can be.
std::size_t examine(const Patch& patch, const CompileOptions& options, Subdivision& subdivision) {
  std::size_t calls = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId a = std::min(patch.corners[k], patch.corners[(k + 1) % 3]);
    const VertexId b = std::max(patch.corners[k], patch.corners[(k + 1) % 3]);
    const ObservedView &from = subdivision.views[number(a)], &to = subdivision.views[number(b)];
    if (from.external_count == 0 || from.external_count != to.external_count) continue;
    ++calls;
    if (subdivision.matches.find(a, b) == nullptr)
      subdivision.matches.add(a, b,
                              match_graphs(from, to, options.match_scales, options.match_limits()));
  }
  return calls;
}

// A patch, and what it is on the subdivision's sphere.
struct Twin {
  PatchId own{}, known{};
};

std::vector<Twin> split_as(const ViewSphere& known, const std::vector<Twin>& twins,
                           ViewSphere& sphere) {
  std::vector<Twin> children;
  for (const Twin& twin : twins) {
    const Patch& patch = known.patch(twin.known);
    if (!patch.split) continue;
    sphere.split(twin.own);
    for (std::size_t k = 0; k < 4; ++k)
      children.push_back({sphere.patch(twin.own).children[k], patch.children[k]});
  }
  return children;
}

}  // namespace

std::vector<LevelCoverage> coverage_by_level(Subdivision& subdivision,
                                             const CompileOptions& options) {
  std::vector<LevelCoverage> levels;
  ViewSphere sphere;
  std::vector<Twin> twins;
  for (const PatchId root : sphere.leaves()) twins.push_back({root, root});
  std::size_t calls = 0;
  for (int level = 0; level <= options.level && !twins.empty(); ++level) {
    if (level >= std::min(kFirstLevel, options.min_level)) {
      // The compiler does not look at levels below its least one: theirs do not add up.
      if (level <= options.min_level) calls = 0;
      for (const Twin& twin : twins) calls += examine(sphere.patch(twin.own), options, subdivision);
      const ClusterStatistics found = statistics_of(find_clusters(sphere, subdivision, options));
      levels.push_back({level, sphere.leaves().size(), sphere.vertex_count(), calls, found.clusters,
                        found.area_fraction});
    }
    twins = split_as(subdivision.sphere, twins, sphere);
  }
  return levels;
}

}  // namespace aspect
