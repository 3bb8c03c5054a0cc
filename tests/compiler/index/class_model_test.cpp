#include "compiler/index/class_model.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>
#include <set>

#include "tests/compiler/index/index_contents.h"

namespace aspect {
namespace {

double sum_of_scores(const ContourDescription& contour) {
  double sum = 0;
  for (const auto& [type, score] : contour.score_of_type) sum += score;
  return sum;
}

std::set<std::uint16_t> types_of(const ContourDescription& contour) {
  std::set<std::uint16_t> types;
  for (const auto& [type, score] : contour.score_of_type) types.insert(type);
  return types;
}

}  // namespace

TEST_CASE("scores are ones, numbers of views, or the area that those stand for") {
  const DescribedModel none = described_model("l_shape", 3, Scoring::none);
  const DescribedModel views = described_model("l_shape", 3, Scoring::views);
  const DescribedModel area = described_model("l_shape", 3, Scoring::area);
  for (std::size_t c = 0; c < none.clusters.size(); ++c) {
    const Cluster& cluster = none.clusters[c];
    for (std::size_t k = 0; k < cluster.contour_count; ++k) {
      for (const auto& [type, score] : none.classes[c].contours[k].score_of_type) CHECK(score == 1);
      CHECK(sum_of_scores(views.classes[c].contours[k]) ==
            Approx(static_cast<double>(cluster.views.size())));
      CHECK(sum_of_scores(area.classes[c].contours[k]) == Approx(cluster.area_assigned));
      CHECK(types_of(none.classes[c].contours[k]) == types_of(views.classes[c].contours[k]));
      CHECK(types_of(none.classes[c].contours[k]) == types_of(area.classes[c].contours[k]));
    }
  }
}

TEST_CASE("every contour of every view is of a type that its class knows by its name") {
  const DescribedModel described = described_model("l_shape", 3);
  const Subdivision& s = described.model.subdivision;
  for (std::size_t c = 0; c < described.classes.size(); ++c) {
    const Cluster& cluster = described.clusters[c];
    CHECK(described.classes[c].view_count == cluster.views.size());
    for (const ClusterView& view : cluster.views) {
      const ObservedView& seen = s.views[place_of(view.vertex)];
      for (std::size_t i = 0; i < cluster.contour_count; ++i) {
        const auto type = nearest_type(described.types, type_attributes(seen.contours[i].feature));
        CHECK(described.classes[c].contours[view.names[i]].score_of_type.contains(type));
      }
    }
  }
}

TEST_CASE("every external contour of every view of a cluster is a sample, and no hole is") {
  const DescribedModel described = described_model("holeblock", 3);
  std::size_t wanted = 0;
  for (const Cluster& cluster : described.clusters)
    wanted += cluster.views.size() * cluster.contour_count;
  CHECK(contour_samples(described.model.subdivision, described.clusters).size() == wanted);
}

TEST_CASE("no view is farther from a key view than the spacing, and no two key views are nearer") {
  const CompiledModel& model = compiled_model("cube", 3);
  for (const Cluster& cluster : model.clusters) {
    for (const double spacing_deg : {5.0, 10.0, 20.0, 60.0}) {
      const double spacing = spacing_deg * std::numbers::pi / 180;
      const std::size_t typical = cluster.views.size() / 2;
      const auto keys = choose_key_views(model.subdivision, cluster, typical, spacing);
      const auto angle = [&](std::size_t a, std::size_t b) {
        const ViewSphere& sphere = model.subdivision.sphere;
        return std::acos(std::clamp(
            sphere.position(cluster.views[a].vertex).dot(sphere.position(cluster.views[b].vertex)),
            -1.0, 1.0));
      };
      REQUIRE(keys.front() == typical);
      for (std::size_t i = 0; i < cluster.views.size(); ++i) {
        const bool near = std::any_of(keys.begin(), keys.end(), [&](std::size_t key) {
          return angle(i, key) <= spacing + 1e-9;
        });
        CHECK(near);
      }
      for (std::size_t i = 0; i < keys.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) CHECK(angle(keys[i], keys[k]) > spacing - 1e-9);
    }
  }
}

}  // namespace aspect
