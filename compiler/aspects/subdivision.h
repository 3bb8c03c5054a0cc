// Adaptive subdivision of the viewing sphere (thesis 3.3.2): views are taken at the corners of
// patches, and a patch whose corners do not match is split.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "compiler/aspects/compile_options.h"
#include "compiler/aspects/observer.h"
#include "compiler/matching/graph_match.h"
#include "compiler/store/store.h"
#include "compiler/viewsphere/viewsphere.h"
#include "runtime/base/result.h"

namespace aspect {

struct Progress {
  int level = 0;
  int border_round = 0, border_rounds = 0;  // of bisection, after the last level
  std::size_t views_of_level = 0;  // new at this level or in this round, from a store or not
  std::size_t views_done = 0, views_wanted = 0;      // of those, to be rendered
  std::size_t matches_done = 0, matches_wanted = 0;  // of this level; none before the views are
  std::size_t views_total = 0;                       // rendered in this run
  double area_accepted = 0;  // share of the sphere in accepted patches so far
  std::size_t clusters = 0;  // once known
};
using ShowProgress = std::function<void(const Progress&)>;

// Every match that was computed, once for both directions.
class MatchTable {
 public:
  // Null where the pair was never matched. The mapping goes from the lower vertex to the higher.
  const GraphMatch* find(VertexId a, VertexId b) const;
  void add(VertexId a, VertexId b, GraphMatch match);

  // kNoMatch where the pair was never matched.
  double cost(VertexId a, VertexId b) const;

  std::size_t size() const { return matches_.size(); }

 private:
  std::unordered_map<std::uint64_t, GraphMatch> matches_;
};

// One number for a pair of views, whichever comes first.
std::uint64_t pair_key(VertexId a, VertexId b);

// A view taken on the edge between two corners.
struct EdgeView {
  double place = 0;  // 0 at the corner with the lower number, 1 at the other
  VertexId view{};
};

struct SubdivisionStatistics {
  std::size_t patches = 0;           // at completion
  std::size_t views = 0;             // at their corners
  std::size_t border_views = 0;      // on edges between aspects
  std::size_t views_rendered = 0;    // in this run; the others came from the store
  std::size_t match_calls = 0;       // pairs of equal node counts that were asked for
  std::size_t matches_executed = 0;  // of those, computed in this run
  std::size_t matches_gave_up = 0;
  std::chrono::nanoseconds render_time{}, feature_time{}, match_time{};  // summed over threads
};

struct Subdivision {
  ViewSphere sphere;
  // By vertex; those on edges follow, numbered as if they were vertices too.
  std::vector<ObservedView> views;
  MatchTable matches;
  // By pair_key of the edge's corners, in order of their places: see borders.h.
  std::unordered_map<std::uint64_t, std::vector<EdgeView>> edge_views;
  SubdivisionStatistics statistics;

  const Eigen::Vector3d& direction(VertexId view) const {
    return views[static_cast<std::size_t>(view)].direction;
  }
};

// The corners of a patch match each other within a threshold.
bool is_uniform(const Subdivision& subdivision, const Patch& patch, double threshold);

// What one run works with. All but the store may be shared.
struct Workshop {
  const Renderer& renderer;
  const Studio& studio;
  const CompileOptions& options;
  Store* store = nullptr;                   // null: nothing is kept
  ShowProgress show_progress;               // may be empty
  const std::atomic<bool>* stop = nullptr;  // set by a signal: finish at the next chance
};

// What there is to say when `stop` was set; kept: in a store.
Error interruption(bool is_kept);

// Same result for any number of threads. An error where the store fails or `stop` was set.
Result<Subdivision> subdivide(const Workshop& workshop);

}  // namespace aspect
