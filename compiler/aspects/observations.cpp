#include "compiler/aspects/observations.h"

#include <algorithm>

#include "compiler/aspects/portions.h"
#include "compiler/aspects/view_codec.h"

namespace aspect {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

std::size_t Observations::KeyHash::operator()(const Key& direction) const {
  std::size_t hash = 0;
  for (const double x : direction) hash = hash * 1000003U ^ std::hash<double>{}(x);
  return hash;
}

Observations::Key Observations::key_of(const Eigen::Vector3d& d) {
  return {d.x(), d.y(), d.z()};
}

Observations::Observations(const Workshop& workshop, Subdivision& found)
    : workshop_(workshop), found_(found), observers_([&workshop] {
        return Observer(workshop.renderer, workshop.studio, workshop.options.vision);
      }) {}

Result<Done> Observations::remember() {
  if (workshop_.store == nullptr) return Done{};
  Result<Done> views =
      workshop_.store->each_view([&](const Eigen::Vector3d& direction, Store::Bytes bytes) {
        if (stopped()) return;
        if (std::optional<ObservedView> view = decode_view(direction, bytes))
          remembered_.views.emplace(key_of(direction), std::move(*view));
      });
  if (!views) return views;
  return workshop_.store->each_match(
      [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to, double cost, Store::Bytes bytes) {
        if (stopped()) return;
        remembered_.matches[key_of(from)][key_of(to)] = decode_match(cost, bytes);
      });
}

void Observations::show() const {
  if (workshop_.show_progress) workshop_.show_progress(progress);
}

Result<Done> Observations::flush_and_stop() {
  if (workshop_.store != nullptr)
    if (Result<Done> done = workshop_.store->flush(); !done) return done;
  return interruption(workshop_.store != nullptr);
}

Result<Done> Observations::observe(const std::vector<Wanted>& wanted) {
  std::vector<Wanted> missing;
  progress.views_of_level = 0;
  for (const auto& [view, direction] : wanted) {
    if (number(view) >= observed_.size()) {
      observed_.resize(number(view) + 1, false);
      found_.views.resize(number(view) + 1);
    }
    if (observed_[number(view)]) continue;
    observed_[number(view)] = true;
    ++progress.views_of_level;
    const auto known = remembered_.views.find(key_of(direction));
    if (known == remembered_.views.end()) {
      missing.push_back({view, direction});
      continue;
    }
    found_.views[number(view)] = std::move(known->second);
    remembered_.views.erase(known);
  }
  progress.views_wanted = missing.size();
  progress.views_done = progress.matches_done = progress.matches_wanted = 0;
  show();
  Result<Done> done = run_in_portions(
      missing.size(), workshop_.stop,
      [&](std::size_t i) {
        found_.views[number(missing[i].view)] = observers_.local().observe(missing[i].direction);
      },
      [&](std::size_t i) { return keep_view(missing[i].view); },
      [&](std::size_t end) {
        progress.views_done = end;
        show();
      });
  return done.ok() && stopped() ? flush_and_stop() : done;
}

Result<Done> Observations::keep_view(VertexId id) {
  progress.views_total = ++found_.statistics.views_rendered;
  if (workshop_.store == nullptr) return Done{};
  const ObservedView& view = found_.views[number(id)];
  return workshop_.store->add_view(view.direction, encode_view(view));
}

std::vector<ViewPair> Observations::missing(const std::vector<ViewPair>& pairs) {
  std::vector<ViewPair> left;
  for (const ViewPair& pair : pairs) {
    const auto [low, high] = std::minmax(pair.first, pair.second);
    const ObservedView &a = found_.views[number(low)], &b = found_.views[number(high)];
    if (a.external_count == 0 || a.external_count != b.external_count) continue;
    ++found_.statistics.match_calls;
    if (asked_.insert(pair_key(low, high)).second && !recall(low, high))
      left.emplace_back(low, high);
  }
  return left;
}

// A mapping from a store is used only where it is one.
bool Observations::fits(const GraphMatch& match, VertexId from) const {
  const std::size_t n = found_.views[number(from)].external_count;
  if (match.mapping.empty()) return match.cost == kNoMatch;
  std::vector<bool> met(n, false);
  for (const std::uint8_t k : match.mapping) {
    if (k >= n || met[k]) return false;
    met[k] = true;
  }
  return match.mapping.size() == n;
}

bool Observations::recall(VertexId from, VertexId to) {
  const Key here = key_of(found_.direction(from)), there = key_of(found_.direction(to));
  for (const bool forward : {true, false}) {
    const auto row = remembered_.matches.find(forward ? here : there);
    if (row == remembered_.matches.end()) continue;
    const auto match = row->second.find(forward ? there : here);
    if (match == row->second.end() || !fits(match->second, from)) continue;
    found_.matches.add(from, to, forward ? match->second : reversed(match->second));
    return true;
  }
  return false;
}

Result<Done> Observations::match(const std::vector<ViewPair>& wanted) {
  const std::vector<ViewPair> pairs = missing(wanted);
  std::vector<GraphMatch> matches(pairs.size());
  tbb::enumerable_thread_specific<std::chrono::nanoseconds> times;
  progress.matches_wanted = pairs.size();
  show();
  const MatchLimits limits = workshop_.options.match_limits();
  Result<Done> done = run_in_portions(
      pairs.size(), workshop_.stop,
      [&](std::size_t i) {
        const auto start = Clock::now();
        matches[i] = match_graphs(found_.views[number(pairs[i].first)],
                                  found_.views[number(pairs[i].second)],
                                  workshop_.options.match_scales, limits);
        times.local() += Clock::now() - start;
      },
      [&](std::size_t i) { return keep_match(pairs[i], std::move(matches[i])); },
      [&](std::size_t end) {
        progress.matches_done = end;
        show();
      });
  for (const std::chrono::nanoseconds time : times) found_.statistics.match_time += time;
  return done.ok() && stopped() ? flush_and_stop() : done;
}

Result<Done> Observations::keep_match(const ViewPair& pair, GraphMatch match) {
  const auto [a, b] = pair;
  ++found_.statistics.matches_executed;
  if (match.gave_up) ++found_.statistics.matches_gave_up;
  if (workshop_.store != nullptr) {
    Result<Done> done = workshop_.store->add_match(found_.direction(a), found_.direction(b),
                                                   match.cost, encode_mapping(match));
    if (!done) return done;
  }
  found_.matches.add(a, b, std::move(match));
  return Done{};
}

void Observations::complete_statistics() {
  SubdivisionStatistics& s = found_.statistics;
  s.patches = found_.sphere.leaves().size();
  s.views = found_.sphere.vertex_count();
  s.border_views = found_.views.size() - s.views;
  for (const Observer& observer : observers_) {
    s.render_time += observer.render_time();
    s.feature_time += observer.feature_time();
  }
}

}  // namespace aspect
