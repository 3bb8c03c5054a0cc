// What must hold of the subdivision and the clusters of any object.
#include "compiler/aspects/clusters.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "tests/compiler/aspects/compiled_model.h"

namespace aspect {
namespace {

const std::vector<std::pair<std::string, int>> kModels = {
    {"cube", 4}, {"l_shape", 4}, {"dumbbell", 3}, {"holeblock", 3}};

// Which leaves belong together, joined pair by pair.
class Components {
 public:
  explicit Components(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

 private:
  std::vector<std::size_t> parent_;
};

// Algorithm 3.1's "match" for two uniform neighbours.
bool match(const CompiledModel& model, PatchId a, PatchId b) {
  const ViewSphere& sphere = model.subdivision.sphere;
  double nearest = std::numeric_limits<double>::infinity();
  VertexId from{}, to{};
  for (const VertexId p : sphere.patch(a).corners) {
    for (const VertexId q : sphere.patch(b).corners) {
      const double distance = (sphere.position(p) - sphere.position(q)).norm();
      if (distance >= nearest) continue;
      nearest = distance;
      from = p;
      to = q;
    }
  }
  if (from == to) return true;
  const auto& views = model.subdivision.views;
  return match_graphs(views[place_of(from)], views[place_of(to)], model.options.match_scales,
                      model.options.match_limits())
             .cost <= model.options.cluster_threshold;
}

// The clusters as sets of leaves, found without any order of growing.
std::set<std::set<PatchId>> plain_clusters(const CompiledModel& model) {
  const Subdivision& s = model.subdivision;
  const auto uniform = [&](PatchId leaf) {
    return is_uniform(s, s.sphere.patch(leaf), model.options.cluster_threshold);
  };
  Components components(s.sphere.patch_count());
  for (const PatchId leaf : s.sphere.leaves())
    for (const PatchId other : s.sphere.neighbours(leaf))
      if (uniform(leaf) && uniform(other) && match(model, leaf, other))
        components.join(place_of(leaf), place_of(other));
  std::map<std::size_t, std::set<PatchId>> sets;
  for (const PatchId leaf : s.sphere.leaves())
    if (uniform(leaf)) sets[components.root(place_of(leaf))].insert(leaf);
  std::set<std::set<PatchId>> clusters;
  for (const auto& [root, patches] : sets) {
    double area = 0;
    for (const PatchId patch : patches) area += s.sphere.area_sr(patch) / (4 * std::numbers::pi);
    if (area >= model.options.small_cluster_fraction) clusters.insert(patches);
  }
  return clusters;
}

// A view on an edge of the patch has another number of contours than the edge's ends.
bool border_on_edge(const Subdivision& s, const Patch& patch) {
  const auto count = [&](VertexId v) { return s.views[place_of(v)].external_count; };
  for (std::size_t i = 0; i < s.sphere.vertex_count(); ++i) {
    const VertexId vertex = static_cast<VertexId>(i);
    if (count(vertex) == count(patch.corners[0])) continue;
    const Eigen::Vector3d& p = s.sphere.position(vertex);
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d& a = s.sphere.position(patch.corners[k]);
      const Eigen::Vector3d& b = s.sphere.position(patch.corners[(k + 1) % 3]);
      const bool between = a.dot(p) > a.dot(b) && b.dot(p) > a.dot(b);
      if (between && std::abs(a.cross(b).dot(p)) < 1e-9) return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("patches are split where their views differ and nowhere else") {
  for (const auto& [name, level] : kModels) {
    const CompiledModel& model = compiled_model(name, level);
    const Subdivision& s = model.subdivision;
    for (std::size_t i = 0; i < s.sphere.patch_count(); ++i) {
      const Patch& patch = s.sphere.patch(static_cast<PatchId>(i));
      const bool uniform = is_uniform(s, patch, model.options.threshold);
      if (patch.split && patch.level >= model.options.min_level)
        CHECK((!uniform || border_on_edge(s, patch)));
      if (patch.split) continue;
      CHECK(patch.level >= model.options.min_level);
      CHECK(patch.level <= level);
      if (patch.level < level) CHECK((uniform && !border_on_edge(s, patch)));
    }
  }
}

TEST_CASE("every corner of every leaf was seen, from where it is") {
  for (const auto& [name, level] : kModels) {
    const Subdivision& s = compiled_model(name, level).subdivision;
    CHECK(s.statistics.views_rendered == s.views.size());
    for (const PatchId leaf : s.sphere.leaves()) {
      for (const VertexId corner : s.sphere.patch(leaf).corners) {
        const ObservedView& view = s.views[place_of(corner)];
        CHECK(view.direction == s.sphere.position(corner));
        CHECK(std::abs(view.right.dot(view.direction)) < 1e-12);
        CHECK(view.external_count > 0);
        CHECK(view.area_px > 0);
      }
    }
  }
}

TEST_CASE("a pair of views is matched once, and only where the numbers of contours are equal") {
  for (const auto& [name, level] : kModels) {
    const Subdivision& s = compiled_model(name, level).subdivision;
    CHECK(s.statistics.matches_executed == s.matches.size());
    CHECK(s.statistics.match_calls >= s.statistics.matches_executed);
    for (const PatchId leaf : s.sphere.leaves()) {
      const auto& c = s.sphere.patch(leaf).corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexId a = c[k], b = c[(k + 1) % 3];
        const bool equal =
            s.views[place_of(a)].external_count == s.views[place_of(b)].external_count;
        CHECK((s.matches.find(a, b) != nullptr) == equal);
        CHECK(s.matches.find(a, b) == s.matches.find(b, a));
      }
    }
  }
}

TEST_CASE("clusters are the connected sets of uniform patches that match") {
  for (const auto& [name, level] : kModels) {
    const CompiledModel& model = compiled_model(name, level);
    std::set<std::set<PatchId>> found;
    for (const Cluster& cluster : model.clusters)
      found.insert({cluster.patches.begin(), cluster.patches.end()});
    INFO(name);
    CHECK(found.size() == model.clusters.size());
    CHECK(found == plain_clusters(model));
  }
}

TEST_CASE("no patch is in two clusters, and the largest cluster comes first") {
  for (const auto& [name, level] : kModels) {
    const CompiledModel& model = compiled_model(name, level);
    std::set<PatchId> met;
    double before = 1;
    for (const Cluster& cluster : model.clusters) {
      for (const PatchId patch : cluster.patches) CHECK(met.insert(patch).second);
      CHECK(cluster.area_fraction <= before);
      CHECK(cluster.area_fraction >= model.options.small_cluster_fraction);
      before = cluster.area_fraction;
    }
  }
}

TEST_CASE("the views of a cluster are the corners of its patches and weigh as much as they") {
  for (const auto& [name, level] : kModels) {
    const CompiledModel& model = compiled_model(name, level);
    for (const Cluster& cluster : model.clusters) {
      std::set<VertexId> corners, views;
      double area = 0, weight = 0;
      for (const PatchId patch : cluster.patches) {
        const auto& c = model.subdivision.sphere.patch(patch).corners;
        corners.insert(c.begin(), c.end());
        area += model.subdivision.sphere.area_sr(patch) / (4 * std::numbers::pi);
      }
      for (const ClusterView& view : cluster.views) {
        views.insert(view.vertex);
        weight += view.weight;
        CHECK(view.weight > 0);
      }
      CHECK(corners == views);
      CHECK(views.size() == cluster.views.size());
      CHECK(area == Approx(cluster.area_fraction).epsilon(1e-12));
      CHECK(weight == Approx(cluster.area_fraction).epsilon(1e-12));
    }
  }
}

TEST_CASE("every view of a cluster names all its contours, each by a name of its own") {
  for (const auto& [name, level] : kModels) {
    const CompiledModel& model = compiled_model(name, level);
    for (const Cluster& cluster : model.clusters) {
      for (const ClusterView& view : cluster.views) {
        CHECK(model.subdivision.views[place_of(view.vertex)].external_count ==
              cluster.contour_count);
        std::vector<std::uint8_t> names = view.names, wanted(cluster.contour_count);
        std::sort(names.begin(), names.end());
        std::iota(wanted.begin(), wanted.end(), std::uint8_t{0});
        CHECK(names == wanted);
      }
    }
  }
}

TEST_CASE("neighbouring views of a cluster agree on names through their match") {
  for (const auto& [name, level] : kModels) {
    const CompiledModel& model = compiled_model(name, level);
    std::size_t agree = 0, all = 0;
    for (const Cluster& cluster : model.clusters) {
      std::map<VertexId, const ClusterView*> view_of;
      for (const ClusterView& view : cluster.views) view_of[view.vertex] = &view;
      for (const PatchId patch : cluster.patches) {
        const auto& c = model.subdivision.sphere.patch(patch).corners;
        for (std::size_t k = 0; k < 3; ++k) {
          const VertexId a = std::min(c[k], c[(k + 1) % 3]), b = std::max(c[k], c[(k + 1) % 3]);
          const GraphMatch& found = *model.subdivision.matches.find(a, b);
          for (std::size_t i = 0; i < found.mapping.size(); ++i, ++all)
            agree += view_of[a]->names[i] == view_of[b]->names[found.mapping[i]] ? 1U : 0U;
        }
      }
    }
    INFO(name << ": " << agree << " of " << all);
    CHECK(static_cast<double>(agree) >= 0.98 * static_cast<double>(all));
  }
}

}  // namespace aspect
