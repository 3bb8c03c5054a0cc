// Level by level: the corners of the new patches are observed and compared, each a loop of
// independent tasks whose results land in places fixed beforehand; then patches that are not
// uniform are split. A pair of views is matched once, from the lower vertex to the higher, and
// only where both have equally many nodes.
#include "compiler/aspects/subdivision.h"

#include <algorithm>
#include <numbers>

#include "compiler/aspects/borders.h"
#include "compiler/aspects/observations.h"

namespace aspect {
namespace {

Result<Done> examine(const std::vector<PatchId>& patches, const Subdivision& found,
                     Observations& observations) {
  std::vector<Observations::Wanted> views;
  std::vector<ViewPair> pairs;
  for (const PatchId id : patches) {
    const auto& c = found.sphere.patch(id).corners;
    for (std::size_t k = 0; k < 3; ++k) {
      views.push_back({c[k], found.sphere.position(c[k])});
      pairs.emplace_back(c[k], c[(k + 1) % 3]);
    }
  }
  if (Result<Done> done = observations.observe(views); !done) return done;
  return observations.match(pairs);
}

std::vector<PatchId> split_all(const std::vector<PatchId>& patches, ViewSphere& sphere) {
  std::vector<PatchId> children;
  for (const PatchId id : patches) {
    sphere.split(id);
    const Patch& split = sphere.patch(id);
    children.insert(children.end(), split.children.begin(), split.children.end());
  }
  return children;
}

Result<Done> split_by_levels(const CompileOptions& options, Subdivision& found,
                             Observations& observations) {
  std::vector<PatchId> patches = found.sphere.leaves();
  for (int level = 0;; ++level) {
    if (level >= options.min_level) {
      observations.progress.level = level;
      if (Result<Done> done = examine(patches, found, observations); !done) return done;
      double& accepted = observations.progress.area_accepted;
      std::erase_if(patches, [&](PatchId id) {
        if (!is_uniform(found, found.sphere.patch(id), options.threshold)) return false;
        accepted += found.sphere.share(id);
        return true;
      });
      if (accepted >= options.stop_area) return Done{};
    }
    if (level == options.level) return Done{};
    patches = split_all(patches, found.sphere);
  }
}

}  // namespace

std::uint64_t pair_key(VertexId a, VertexId b) {
  const auto low = static_cast<std::uint64_t>(std::min(a, b));
  const auto high = static_cast<std::uint64_t>(std::max(a, b));
  return low << 32U | high;
}

const GraphMatch* MatchTable::find(VertexId a, VertexId b) const {
  const auto found = matches_.find(pair_key(a, b));
  return found == matches_.end() ? nullptr : &found->second;
}

void MatchTable::add(VertexId a, VertexId b, GraphMatch match) {
  matches_.insert_or_assign(pair_key(a, b), a < b ? std::move(match) : reversed(match));
}

double MatchTable::cost(VertexId a, VertexId b) const {
  const GraphMatch* match = find(a, b);
  return match == nullptr ? kNoMatch : match->cost;
}

bool is_uniform(const Subdivision& subdivision, const Patch& patch, double threshold) {
  const auto& c = patch.corners;
  return subdivision.matches.cost(c[0], c[1]) <= threshold &&
         subdivision.matches.cost(c[1], c[2]) <= threshold &&
         subdivision.matches.cost(c[2], c[0]) <= threshold;
}

Error interruption(bool is_kept) {
  if (!is_kept) return {"stopped before the index was complete; without a store nothing was kept"};
  return {"stopped before the index was complete; run the same command again to go on"};
}

Result<Subdivision> subdivide(const Workshop& workshop) {
  Subdivision found;
  Observations observations(workshop, found);
  observations.progress.border_rounds = workshop.options.border_views > 0 ? kBisections : 0;
  if (Result<Done> done = observations.remember(); !done) return Error{done.error()};
  if (Result<Done> done = split_by_levels(workshop.options, found, observations); !done)
    return Error{done.error()};
  if (Result<Done> done = find_borders(workshop.options, found, observations); !done)
    return Error{done.error()};
  observations.complete_statistics();
  return found;
}

}  // namespace aspect
