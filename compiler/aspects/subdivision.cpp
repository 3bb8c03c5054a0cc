// Level by level: the corners of the new patches are observed and compared, each a loop of
// independent tasks whose results land in places fixed beforehand; then patches that are not
// uniform are split. A pair of views is matched once, from the lower vertex to the higher, and
// only where both have equally many nodes.
#include "compiler/aspects/subdivision.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <numbers>

#include "compiler/aspects/portions.h"
#include "compiler/aspects/view_codec.h"

namespace aspect {
namespace {

using Clock = std::chrono::steady_clock;

std::size_t number(VertexId vertex) {
  return static_cast<std::size_t>(vertex);
}

std::uint64_t pair_key(VertexId a, VertexId b) {
  const auto low = static_cast<std::uint64_t>(std::min(a, b));
  const auto high = static_cast<std::uint64_t>(std::max(a, b));
  return low << 32U | high;
}

using VertexPair = std::pair<VertexId, VertexId>;

// Directions as map keys, by their bits.
struct DirectionHash {
  std::size_t operator()(const std::array<double, 3>& d) const {
    std::size_t hash = 0;
    for (const double x : d) hash = hash * 1000003U ^ std::hash<double>{}(x);
    return hash;
  }
};
std::array<double, 3> key_of(const Eigen::Vector3d& d) {
  return {d.x(), d.y(), d.z()};
}

// What a store held when it was opened.
struct Remembered {
  std::unordered_map<std::array<double, 3>, ObservedView, DirectionHash> views;
  std::unordered_map<std::array<double, 3>,
                     std::unordered_map<std::array<double, 3>, GraphMatch, DirectionHash>,
                     DirectionHash>
      matches;
};

class Subdivider {
 public:
  explicit Subdivider(const Workshop& workshop)
      : workshop_(workshop), observers_([&workshop] {
          return Observer(workshop.renderer, workshop.studio, workshop.options.vision);
        }) {}

  Result<Subdivision> run() {
    if (Result<Done> done = remember(); !done) return Error{done.error()};
    const CompileOptions& options = workshop_.options;
    std::vector<PatchId> patches = result_.sphere.leaves();
    for (int level = 0; level <= options.level; ++level) {
      if (level >= options.min_level) {
        if (Result<Done> done = examine(patches, level); !done) return Error{done.error()};
      }
      std::vector<PatchId> next;
      for (const PatchId id : patches) {
        if (level >= options.min_level &&
            is_uniform(result_, result_.sphere.patch(id), options.threshold)) {
          progress_.area_accepted += result_.sphere.area_sr(id) / (4 * std::numbers::pi);
          continue;
        }
        if (level == options.level) continue;
        result_.sphere.split(id);
        const Patch& split = result_.sphere.patch(id);
        next.insert(next.end(), split.children.begin(), split.children.end());
      }
      patches = std::move(next);
    }
    for (const Observer& observer : observers_) {
      result_.render_time += observer.render_time();
      result_.feature_time += observer.feature_time();
    }
    return std::move(result_);
  }

 private:
  bool stopped() const { return workshop_.stop != nullptr && workshop_.stop->load(); }
  Result<Done> remember() {
    if (workshop_.store == nullptr) return Done{};
    Result<Done> views =
        workshop_.store->each_view([&](const Eigen::Vector3d& direction, Store::Bytes bytes) {
          if (stopped()) return;
          if (std::optional<ObservedView> view = decode_view(direction, bytes))
            remembered_.views.emplace(key_of(direction), std::move(*view));
        });
    if (!views) return views;
    return workshop_.store->each_match([&](const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                           double cost, Store::Bytes bytes) {
      if (stopped()) return;
      remembered_.matches[key_of(from)][key_of(to)] = decode_match(cost, bytes);
    });
  }

  Result<Done> examine(const std::vector<PatchId>& patches, int level) {
    progress_.level = level;
    if (Result<Done> done = observe_corners(patches); !done) return done;
    return match_corners(patches);
  }

  Result<Done> observe_corners(const std::vector<PatchId>& patches) {
    std::vector<VertexId> missing;
    progress_.views_of_level = 0;
    result_.views.resize(result_.sphere.vertex_count());
    observed_.resize(result_.sphere.vertex_count(), false);
    for (const PatchId id : patches) {
      for (const VertexId corner : result_.sphere.patch(id).corners) {
        if (observed_[number(corner)]) continue;
        observed_[number(corner)] = true;
        ++progress_.views_of_level;
        const auto known = remembered_.views.find(key_of(result_.sphere.position(corner)));
        if (known != remembered_.views.end())
          result_.views[number(corner)] = std::move(known->second);
        else
          missing.push_back(corner);
      }
    }
    progress_.views_wanted = missing.size();
    progress_.views_done = progress_.matches_done = progress_.matches_wanted = 0;
    show();
    Result<Done> done = run_in_portions(
        missing.size(), workshop_.stop,
        [&](std::size_t i) {
          result_.views[number(missing[i])] =
              observers_.local().observe(result_.sphere.position(missing[i]));
        },
        [&](std::size_t i) -> Result<Done> {
          progress_.views_total = ++result_.views_rendered;
          if (workshop_.store == nullptr) return Done{};
          const ObservedView& view = result_.views[number(missing[i])];
          return workshop_.store->add_view(view.direction, encode_view(view));
        },
        [&](std::size_t end) {
          progress_.views_done = end;
          show();
        });
    return done.ok() && stopped() ? flush_and_stop() : done;
  }

  void show() const {
    if (workshop_.show_progress) workshop_.show_progress(progress_);
  }

  Result<Done> flush_and_stop() {
    if (workshop_.store != nullptr)
      if (Result<Done> done = workshop_.store->flush(); !done) return done;
    return interruption(workshop_.store != nullptr);
  }

  // Pairs of corners with equally many nodes that were not matched yet.
  std::vector<VertexPair> missing_pairs(const std::vector<PatchId>& patches) {
    std::vector<VertexPair> pairs;
    for (const PatchId id : patches) {
      const auto& c = result_.sphere.patch(id).corners;
      for (const VertexPair& pair : {VertexPair{c[0], c[1]}, {c[1], c[2]}, {c[2], c[0]}}) {
        const auto [a, b] = std::minmax(pair.first, pair.second);
        const ObservedView &va = result_.views[number(a)], &vb = result_.views[number(b)];
        if (va.external_count == 0 || va.external_count != vb.external_count) continue;
        ++result_.match_calls;
        if (asked_.emplace(pair_key(a, b), true).second) pairs.emplace_back(a, b);
      }
    }
    return pairs;
  }

  // A mapping from a store is used only where it is one.
  bool fits(const GraphMatch& match, VertexId a) const {
    const std::size_t n = result_.views[number(a)].external_count;
    if (match.mapping.empty()) return match.cost == kNoMatch;
    std::vector<bool> met(n, false);
    for (const std::uint8_t k : match.mapping) {
      if (k >= n || met[k]) return false;
      met[k] = true;
    }
    return match.mapping.size() == n;
  }

  bool recall(VertexId a, VertexId b) {
    const auto from = key_of(result_.sphere.position(a)), to = key_of(result_.sphere.position(b));
    for (const bool forward : {true, false}) {
      const auto row = remembered_.matches.find(forward ? from : to);
      if (row == remembered_.matches.end()) continue;
      const auto match = row->second.find(forward ? to : from);
      if (match == row->second.end() || !fits(match->second, a)) continue;
      result_.matches.add(a, b, forward ? match->second : reversed(match->second));
      return true;
    }
    return false;
  }

  Result<Done> match_corners(const std::vector<PatchId>& patches) {
    std::vector<VertexPair> pairs = missing_pairs(patches);
    std::erase_if(pairs,
                  [this](const VertexPair& pair) { return recall(pair.first, pair.second); });
    const CompileOptions& options = workshop_.options;
    std::vector<GraphMatch> matches(pairs.size());
    tbb::enumerable_thread_specific<std::chrono::nanoseconds> times;
    progress_.matches_wanted = pairs.size();
    show();
    Result<Done> done = run_in_portions(
        pairs.size(), workshop_.stop,
        [&](std::size_t i) {
          const auto start = Clock::now();
          matches[i] = match_graphs(result_.views[number(pairs[i].first)],
                                    result_.views[number(pairs[i].second)], options.match_scales,
                                    options.cluster_threshold);
          times.local() += Clock::now() - start;
        },
        [&](std::size_t i) { return keep_match(pairs[i], std::move(matches[i])); },
        [&](std::size_t end) {
          progress_.matches_done = end;
          show();
        });
    for (const std::chrono::nanoseconds time : times) result_.match_time += time;
    return done.ok() && stopped() ? flush_and_stop() : done;
  }

  Result<Done> keep_match(const VertexPair& pair, GraphMatch match) {
    const auto [a, b] = pair;
    ++result_.matches_executed;
    if (match.gave_up) ++result_.matches_gave_up;
    if (workshop_.store != nullptr) {
      Result<Done> done =
          workshop_.store->add_match(result_.sphere.position(a), result_.sphere.position(b),
                                     match.cost, encode_mapping(match));
      if (!done) return done;
    }
    result_.matches.add(a, b, std::move(match));
    return Done{};
  }

  const Workshop& workshop_;
  Subdivision result_;
  Progress progress_;
  Remembered remembered_;
  std::vector<bool> observed_;
  std::unordered_map<std::uint64_t, bool> asked_;
  tbb::enumerable_thread_specific<Observer> observers_;
};

}  // namespace

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
  return Subdivider(workshop).run();
}

}  // namespace aspect
