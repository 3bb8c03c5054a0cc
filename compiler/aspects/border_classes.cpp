#include "compiler/aspects/border_classes.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>
#include <queue>
#include <tuple>

namespace aspect {
namespace {

// The views round a patch, by place, corner 0 first.
std::vector<EdgeView> views_round(const Subdivision& subdivision, const Patch& patch) {
  std::vector<EdgeView> round;
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId from = patch.corners[k], to = patch.corners[(k + 1) % 3];
    const auto edge = static_cast<double>(k);
    round.push_back({edge, from});
    const auto found = subdivision.edge_views.find(pair_key(from, to));
    if (found == subdivision.edge_views.end()) continue;
    const std::size_t first = round.size();
    for (const EdgeView& view : found->second)
      round.push_back({edge + (from < to ? view.place : 1 - view.place), view.view});
    if (from > to) std::reverse(round.begin() + static_cast<std::ptrdiff_t>(first), round.end());
  }
  return round;
}

// Views of different classes that are farther apart, in edges, leave it open where the border is.
constexpr double kWidestGap = 1.0 / 8;

// Borders halfway between views of different classes; what is between views too far apart belongs
// to none.
PatchDivision division_of(const std::vector<EdgeView>& round,
                          const std::vector<std::int32_t>& class_of_view) {
  const auto class_of = [&](std::size_t k) {
    return class_of_view[number(round[k % round.size()].view)];
  };
  PatchDivision along_edges{{0}, {class_of(0)}};
  const auto begin_class = [&](double place, std::int32_t id) {
    along_edges.places.push_back(place);
    along_edges.classes.push_back(id);
  };
  for (std::size_t k = 1; k <= round.size(); ++k) {
    if (class_of(k) == class_of(k - 1)) continue;
    const double from = round[k - 1].place;
    const double to = k == round.size() ? 3 : round[k].place;
    if (to - from <= kWidestGap) {
      begin_class((from + to) / 2, class_of(k));
    } else {
      begin_class(from + kWidestGap / 2, kNoClass);
      begin_class(to - kWidestGap / 2, class_of(k));
    }
  }
  return joined(along_edges);
}

class BorderDivision {
 public:
  BorderDivision(const Subdivision& subdivision, const CompileOptions& options,
                 std::vector<Cluster>& clusters)
      : subdivision_(subdivision), options_(options), clusters_(clusters) {
    const ViewSphere& sphere = subdivision.sphere;
    classes_.class_of.assign(sphere.patch_count(), kNoClass);
    class_of_view_.assign(subdivision.views.size(), kNoClass);
    names_.resize(subdivision.views.size());
    weight_.assign(subdivision.views.size(), 0);
    for (std::size_t c = 0; c < clusters.size(); ++c) {
      for (const PatchId patch : clusters[c].patches)
        classes_.class_of[static_cast<std::size_t>(patch)] = static_cast<std::int32_t>(c);
      for (const ClusterView& view : clusters[c].views) {
        if (class_of_view_[number(view.vertex)] != kNoClass) continue;
        class_of_view_[number(view.vertex)] = static_cast<std::int32_t>(c);
        names_[number(view.vertex)] = view.names;
      }
    }
    for (const PatchId leaf : sphere.leaves())
      if (classes_.class_of[static_cast<std::size_t>(leaf)] == kNoClass) left_.push_back(leaf);
  }

  SphereClasses run() {
    if (subdivision_.edge_views.empty()) return std::move(classes_);
    const Neighbours neighbours = matching_neighbours();
    std::vector<VertexId> added = spread(neighbours);
    const std::size_t uniform_clusters = clusters_.size();
    for (const auto& [seed, ignored] : neighbours)
      if (class_of_view_[number(seed)] == kNoClass) start_cluster(seed, neighbours, added);
    for (const PatchId patch : left_) divide(patch);
    for (std::size_t c = 0; c < clusters_.size(); ++c)
      for (ClusterView& view : clusters_[c].views)
        if (class_of(view.vertex) == c) view.weight += weight_[number(view.vertex)];
    for (const VertexId view : added)
      clusters_[class_of(view)].views.push_back(
          {view, weight_[number(view)], names_[number(view)]});
    drop_small(uniform_clusters);
    return std::move(classes_);
  }

 private:
  // From a view of a cluster to one of none, by a known match.
  struct Step {
    double cost = 0;
    VertexId from{}, to{};
    bool operator>(const Step& other) const {
      return std::tie(cost, from, to) > std::tie(other.cost, other.from, other.to);
    }
  };
  using Steps = std::priority_queue<Step, std::vector<Step>, std::greater<>>;

  // Views round the patches that are left and those next to them that they match.
  using Neighbours = std::map<VertexId, std::vector<VertexId>>;

  std::size_t class_of(VertexId view) const {
    return static_cast<std::size_t>(class_of_view_[number(view)]);
  }

  Neighbours matching_neighbours() const {
    Neighbours neighbours;
    for (const PatchId patch : left_) {
      const std::vector<EdgeView> round =
          views_round(subdivision_, subdivision_.sphere.patch(patch));
      for (std::size_t k = 0; k < round.size(); ++k) {
        const VertexId a = round[k].view, b = round[(k + 1) % round.size()].view;
        if (!(subdivision_.matches.cost(a, b) <= options_.cluster_threshold)) continue;
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
      }
    }
    return neighbours;
  }

  void add_steps(VertexId from, const Neighbours& neighbours, Steps& steps) const {
    for (const VertexId to : neighbours.at(from))
      if (class_of_view_[number(to)] == kNoClass)
        steps.push({subdivision_.matches.cost(from, to), from, to});
  }

  // Takes views without a class into the clusters that they match; returns them.
  std::vector<VertexId> spread(const Neighbours& neighbours) {
    Steps steps;
    for (const auto& [view, ignored] : neighbours)
      if (class_of_view_[number(view)] != kNoClass) add_steps(view, neighbours, steps);
    std::vector<VertexId> taken;
    follow(std::move(steps), neighbours, taken);
    return taken;
  }

  // The cheapest match first.
  void follow(Steps steps, const Neighbours& neighbours, std::vector<VertexId>& added) {
    while (!steps.empty()) {
      const Step step = steps.top();
      steps.pop();
      if (class_of_view_[number(step.to)] != kNoClass) continue;
      take(step);
      added.push_back(step.to);
      add_steps(step.to, neighbours, steps);
    }
  }

  // An aspect too thin for a uniform patch: views on edges that match each other.
  void start_cluster(VertexId seed, const Neighbours& neighbours, std::vector<VertexId>& added) {
    Cluster cluster;
    cluster.contour_count = subdivision_.views[number(seed)].external_count;
    class_of_view_[number(seed)] = static_cast<std::int32_t>(clusters_.size());
    names_[number(seed)].resize(cluster.contour_count);
    std::iota(names_[number(seed)].begin(), names_[number(seed)].end(), std::uint8_t{0});
    clusters_.push_back(std::move(cluster));
    added.push_back(seed);
    Steps steps;
    add_steps(seed, neighbours, steps);
    follow(std::move(steps), neighbours, added);
  }

  // Aspects without a uniform patch that are too small after all.
  void drop_small(std::size_t uniform_clusters) {
    std::vector<std::int32_t> kept_as(clusters_.size() + 1, kNoClass);
    std::vector<Cluster> kept;
    for (std::size_t c = 0; c < clusters_.size(); ++c) {
      if (c >= uniform_clusters && clusters_[c].area_assigned < options_.small_cluster_fraction)
        continue;
      kept_as[c] = static_cast<std::int32_t>(kept.size());
      kept.push_back(std::move(clusters_[c]));
    }
    // The last place is that of kNoClass.
    const auto renumber = [&](std::int32_t& id) {
      id = kept_as[id == kNoClass ? kept_as.size() - 1 : static_cast<std::size_t>(id)];
    };
    for (std::int32_t& id : classes_.class_of) renumber(id);
    for (auto& [patch, division] : classes_.divisions) {
      for (std::int32_t& id : division.classes) renumber(id);
      division = joined(division);
    }
    clusters_ = std::move(kept);
  }

  void take(const Step& step) {
    class_of_view_[number(step.to)] = class_of_view_[number(step.from)];
    const GraphMatch* found = subdivision_.matches.find(step.from, step.to);
    const GraphMatch match = step.from < step.to ? *found : reversed(*found);
    const std::vector<std::uint8_t>& from = names_[number(step.from)];
    std::vector<std::uint8_t>& to = names_[number(step.to)];
    to.resize(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) to[match.mapping[i]] = from[i];
  }

  void divide(PatchId id) {
    const std::vector<EdgeView> round = views_round(subdivision_, subdivision_.sphere.patch(id));
    PatchDivision division = division_of(round, class_of_view_);
    const std::vector<double> shares = piece_shares(division);
    const double area = subdivision_.sphere.share(id);
    for (std::size_t k = 0; k < shares.size(); ++k)
      if (division.classes[k] != kNoClass) assign(round, division.classes[k], shares[k] * area);
    if (division.classes.size() == 1)
      classes_.class_of[static_cast<std::size_t>(id)] = division.classes[0];
    else
      classes_.divisions.emplace(static_cast<std::uint32_t>(id), std::move(division));
  }

  // Shared equally by the patch's views of that class.
  void assign(const std::vector<EdgeView>& round, std::int32_t id, double area) {
    clusters_[static_cast<std::size_t>(id)].area_assigned += area;
    const auto is_own = [&](const EdgeView& view) {
      return class_of_view_[number(view.view)] == id;
    };
    const auto own = std::count_if(round.begin(), round.end(), is_own);
    for (const EdgeView& view : round)
      if (is_own(view)) weight_[number(view.view)] += area / static_cast<double>(own);
  }

  const Subdivision& subdivision_;
  const CompileOptions& options_;
  std::vector<Cluster>& clusters_;
  SphereClasses classes_;
  std::vector<PatchId> left_;  // in no cluster
  std::vector<std::int32_t> class_of_view_;
  std::vector<std::vector<std::uint8_t>> names_;
  std::vector<double> weight_;
};

}  // namespace

SphereClasses divide_borders(const Subdivision& subdivision, const CompileOptions& options,
                             std::vector<Cluster>& clusters) {
  for (Cluster& cluster : clusters) cluster.area_assigned = cluster.area_fraction;
  return BorderDivision(subdivision, options, clusters).run();
}

}  // namespace aspect
