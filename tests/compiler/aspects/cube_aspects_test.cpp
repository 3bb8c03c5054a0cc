// The clusters of a cube against the exact arrangement of its face planes: 6 aspects show one face,
// 12 two and 8 three.
#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <map>
#include <numbers>
#include <set>

#include "compiler/index/class_model.h"
#include "tests/compiler/aspects/compiled_model.h"
#include "tests/compiler/aspects/face_planes.h"

namespace aspect {
namespace {

constexpr int kAspects = 26;
constexpr double kClear = 0.02;  // distance from a plane at which every face is 5 pixels thick

struct Cube {
  const CompiledModel& model;
  std::vector<FacePlane> planes = face_planes(model.scene);

  const Eigen::Vector3d& corner(PatchId patch, std::size_t k) const {
    const ViewSphere& sphere = model.subdivision.sphere;
    return sphere.position(sphere.patch(patch).corners[k]);
  }
  double area(PatchId patch) const {
    return model.subdivision.sphere.area_sr(patch) / (4 * std::numbers::pi);
  }
  VisibleFaces faces(PatchId patch, std::size_t k) const {
    return visible_faces(planes, corner(patch, k));
  }
  bool is_pure(PatchId patch) const {
    return faces(patch, 0) == faces(patch, 1) && faces(patch, 1) == faces(patch, 2);
  }
  bool is_clear(PatchId patch) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (distance_to_nearest(planes, corner(patch, k)) < kClear) return false;
    return true;
  }
  // What most patches of a cluster show, by area.
  VisibleFaces faces(const Cluster& cluster) const {
    std::map<VisibleFaces, double> area_of;
    for (const PatchId patch : cluster.patches)
      if (is_pure(patch)) area_of[faces(patch, 0)] += area(patch);
    const auto less = [](const auto& a, const auto& b) { return a.second < b.second; };
    return area_of.empty() ? 0 : std::max_element(area_of.begin(), area_of.end(), less)->first;
  }
};

Cube cube(int level) {
  return {compiled_model("cube", level)};
}

}  // namespace

TEST_CASE("the exact arrangement of a cube has 26 cells that cover the sphere") {
  const auto areas = exact_areas(cube(3).planes, 100000);
  std::map<int, int> cells_of_count;
  double total = 0;
  for (const auto& [faces, area] : areas) {
    ++cells_of_count[std::popcount(faces)];
    total += area;
  }
  CHECK(cells_of_count == std::map<int, int>{{1, 6}, {2, 12}, {3, 8}});
  CHECK(total == Approx(1));
}

TEST_CASE("a cube has one cluster for every cell of the exact arrangement") {
  for (const int level : {3, 4}) {
    INFO("level " << level);
    const Cube c = cube(level);
    std::set<VisibleFaces> found;
    for (const Cluster& cluster : c.model.clusters) found.insert(c.faces(cluster));
    CHECK(c.model.clusters.size() == kAspects);
    CHECK(found.size() == kAspects);
    for (const auto& [faces, area] : exact_areas(c.planes, 100000)) CHECK(found.contains(faces));
  }
}

TEST_CASE("all patches of a cluster see the same faces, but for slivers at its border") {
  for (const int level : {3, 4}) {
    const Cube c = cube(level);
    std::size_t patches = 0, odd = 0, clear = 0;
    for (const Cluster& cluster : c.model.clusters) {
      const VisibleFaces faces = c.faces(cluster);
      for (const PatchId patch : cluster.patches) {
        const bool same = c.is_pure(patch) && c.faces(patch, 0) == faces;
        ++patches;
        odd += same ? 0 : 1;
        if (!c.is_clear(patch)) continue;
        ++clear;
        CHECK(same);
      }
    }
    INFO("level " << level << ": " << patches << " patches, " << odd << " at the border");
    CHECK(odd * 4 < patches);
    CHECK(clear * 3 > patches);
  }
}

TEST_CASE("a patch that sees the same faces from all corners, clearly, is in their cluster") {
  for (const int level : {3, 4}) {
    const Cube c = cube(level);
    std::map<PatchId, VisibleFaces> cluster_of;
    for (const Cluster& cluster : c.model.clusters)
      for (const PatchId patch : cluster.patches) cluster_of[patch] = c.faces(cluster);
    std::size_t clear = 0, missing = 0;
    for (const PatchId leaf : c.model.subdivision.sphere.leaves()) {
      if (!c.is_pure(leaf) || !c.is_clear(leaf)) continue;
      ++clear;
      if (!cluster_of.contains(leaf))
        ++missing;
      else
        CHECK(cluster_of[leaf] == c.faces(leaf, 0));
    }
    INFO("level " << level << ": " << missing << " of " << clear);
    CHECK(missing == 0);
  }
}

TEST_CASE("no cluster is larger than its cell and the patches on the cell's border") {
  for (const int level : {3, 4}) {
    const Cube c = cube(level);
    const auto exact = exact_areas(c.planes, 400000);
    for (const Cluster& cluster : c.model.clusters) {
      const double cell = exact.at(c.faces(cluster));
      double border = 0, inside = 0;
      for (const PatchId patch : cluster.patches)
        (c.is_pure(patch) && c.faces(patch, 0) == c.faces(cluster) ? inside : border) +=
            c.area(patch);
      INFO("level " << level << ": cell " << cell << ", cluster " << cluster.area_fraction);
      CHECK(inside + border == Approx(cluster.area_fraction));
      CHECK(cluster.area_fraction <= cell + border + 1e-4);
      // The finer the patches, the more of the cell is found.
      CHECK(cluster.area_fraction >= (level == 3 ? 0.2 : 0.5) * cell);
    }
  }
}

TEST_CASE("the contours of a class are the visible faces") {
  for (const int level : {3, 4}) {
    const Cube c = cube(level);
    for (const Cluster& cluster : c.model.clusters) {
      const ClassDescription description =
          describe_class(c.model.subdivision, cluster, {}, Scoring::views);
      VisibleFaces named = 0;
      for (const ContourDescription& contour : description.contours) {
        REQUIRE(contour.surfaces.size() == 1);
        named |= 1U << (contour.surfaces.front() - 1U);
      }
      CHECK(named == c.faces(cluster));
      CHECK(static_cast<int>(cluster.contour_count) == std::popcount(named));
    }
  }
}

TEST_CASE("a name stands for the same face in every view of its cluster") {
  for (const int level : {3, 4}) {
    const Cube c = cube(level);
    for (const Cluster& cluster : c.model.clusters) {
      std::map<std::uint8_t, std::set<std::uint16_t>> faces_of;
      for (const ClusterView& view : cluster.views) {
        const ObservedView& seen = c.model.subdivision.views[place_of(view.vertex)];
        REQUIRE(view.names.size() == seen.external_count);
        for (std::size_t i = 0; i < view.names.size(); ++i)
          faces_of[view.names[i]].insert(main_surface(seen.contours[i]));
      }
      CHECK(faces_of.size() == cluster.contour_count);
      for (const auto& [name, faces] : faces_of) CHECK(faces.size() == 1);
    }
  }
}

TEST_CASE("the centre of a named contour lies on its face") {
  const Cube c = cube(3);
  for (const Cluster& cluster : c.model.clusters) {
    const ClassDescription description =
        describe_class(c.model.subdivision, cluster, {}, Scoring::views);
    for (const ContourDescription& contour : description.contours) {
      const FacePlane& plane = c.planes[contour.surfaces.front() - 1U];
      CHECK(std::abs(plane.above(contour.centre_object)) < 0.005);
      CHECK(contour.centre_object.norm() < 1.5 * plane.distance);
    }
  }
}

}  // namespace aspect
