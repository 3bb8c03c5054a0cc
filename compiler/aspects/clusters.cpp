#include "compiler/aspects/clusters.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>
#include <unordered_map>

namespace aspect {
namespace {

// A known match between two views of a cluster, to carry names over.
struct Link {
  VertexId to{};
  GraphMatch match;  // from here to there
};
using Links = std::map<VertexId, std::vector<Link>>;

class Clustering {
 public:
  Clustering(const ViewSphere& sphere, const Subdivision& subdivision,
             const CompileOptions& options)
      : sphere_(sphere), subdivision_(subdivision), options_(options) {}

  std::vector<Cluster> run() {
    const std::vector<PatchId> leaves = sphere_.leaves();
    waiting_.assign(sphere_.patch_count(), false);
    for (const PatchId leaf : leaves)
      waiting_[number(leaf)] = is_uniform(subdivision_, patch(leaf), options_.cluster_threshold);
    std::vector<Cluster> clusters;
    for (const PatchId leaf : leaves) {
      if (!waiting_[number(leaf)]) continue;
      Links links;
      Cluster cluster = grow(leaf, links);
      if (cluster.area_fraction < options_.small_cluster_fraction) continue;
      collect_views(cluster);
      name_contours(cluster, links);
      clusters.push_back(std::move(cluster));
    }
    std::stable_sort(clusters.begin(), clusters.end(), [](const Cluster& a, const Cluster& b) {
      return a.area_fraction > b.area_fraction;
    });
    return clusters;
  }

 private:
  const Patch& patch(PatchId id) const { return sphere_.patch(id); }

  Cluster grow(PatchId seed, Links& links) {
    Cluster cluster;
    std::vector<PatchId> open{seed};
    waiting_[number(seed)] = false;
    while (!open.empty()) {
      const PatchId at = open.back();
      open.pop_back();
      cluster.patches.push_back(at);
      cluster.area_fraction += sphere_.share(at);
      for (const PatchId neighbour : sphere_.neighbours(at)) {
        if (!waiting_[number(neighbour)] || !match(at, neighbour, links)) continue;
        waiting_[number(neighbour)] = false;
        open.push_back(neighbour);
      }
    }
    std::sort(cluster.patches.begin(), cluster.patches.end());
    return cluster;
  }

  bool match(PatchId a, PatchId b, Links& links) const {
    VertexId from{}, to{};
    double nearest = std::numeric_limits<double>::infinity();
    for (const VertexId p : patch(a).corners) {
      for (const VertexId q : patch(b).corners) {
        if (p == q) return true;
        const double distance =
            (subdivision_.direction(p) - subdivision_.direction(q)).squaredNorm();
        if (distance >= nearest) continue;
        nearest = distance;
        from = p;
        to = q;
      }
    }
    GraphMatch found =
        match_graphs(subdivision_.views[number(from)], subdivision_.views[number(to)],
                     options_.match_scales, options_.match_limits());
    if (!(found.cost <= options_.cluster_threshold)) return false;
    links[to].push_back({from, reversed(found)});
    links[from].push_back({to, std::move(found)});
    return true;
  }

  // A view's weight is a third of the area of the patches that it is a corner of.
  void collect_views(Cluster& cluster) const {
    std::map<VertexId, double> weights;
    for (const PatchId id : cluster.patches) {
      const double third = sphere_.area_sr(id) / (12 * std::numbers::pi);
      for (const VertexId corner : patch(id).corners) weights[corner] += third;
    }
    for (const auto& [vertex, weight] : weights) cluster.views.push_back({vertex, weight, {}});
    cluster.contour_count = subdivision_.views[number(cluster.views.front().vertex)].external_count;
  }

  // Carries the names of the first view from neighbour to neighbour through known matches.
  void name_contours(Cluster& cluster, Links& links) const {
    std::unordered_map<std::uint32_t, std::size_t> place;
    for (std::size_t i = 0; i < cluster.views.size(); ++i)
      place[static_cast<std::uint32_t>(cluster.views[i].vertex)] = i;
    for (const PatchId id : cluster.patches) {
      const auto& c = patch(id).corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexId a = c[k], b = c[(k + 1) % 3];
        const GraphMatch* found = subdivision_.matches.find(a, b);
        const GraphMatch forward = a < b ? *found : reversed(*found);
        links[b].push_back({a, reversed(forward)});
        links[a].push_back({b, forward});
      }
    }
    ClusterView& first = cluster.views.front();
    first.names.resize(cluster.contour_count);
    std::iota(first.names.begin(), first.names.end(), std::uint8_t{0});
    std::vector<VertexId> open{first.vertex};
    for (std::size_t next = 0; next < open.size(); ++next) {
      const ClusterView& from = cluster.views[place[static_cast<std::uint32_t>(open[next])]];
      for (const Link& link : links[open[next]]) {
        ClusterView& to = cluster.views[place[static_cast<std::uint32_t>(link.to)]];
        if (!to.names.empty()) continue;
        to.names.resize(cluster.contour_count);
        for (std::size_t i = 0; i < cluster.contour_count; ++i)
          to.names[link.match.mapping[i]] = from.names[i];
        open.push_back(link.to);
      }
    }
  }

  const ViewSphere& sphere_;
  const Subdivision& subdivision_;
  const CompileOptions& options_;
  std::vector<bool> waiting_;  // uniform leaves that are in no cluster yet
};

}  // namespace

ClusterStatistics statistics_of(const std::vector<Cluster>& clusters) {
  ClusterStatistics sum{clusters.size()};
  for (const Cluster& cluster : clusters) {
    sum.area_fraction += cluster.area_fraction;
    sum.area_assigned += cluster.area_assigned;
  }
  return sum;
}

std::vector<Cluster> find_clusters(const Subdivision& subdivision, const CompileOptions& options) {
  return find_clusters(subdivision.sphere, subdivision, options);
}

std::vector<Cluster> find_clusters(const ViewSphere& sphere, const Subdivision& subdivision,
                                   const CompileOptions& options) {
  return Clustering(sphere, subdivision, options).run();
}

}  // namespace aspect
