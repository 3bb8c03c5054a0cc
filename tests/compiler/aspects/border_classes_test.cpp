// Divided patches against the exact arrangement of the cube's face planes.
#include "compiler/aspects/border_classes.h"

#include <catch2/catch.hpp>
#include <map>
#include <numbers>
#include <random>

#include "tests/compiler/aspects/compiled_model.h"
#include "tests/compiler/aspects/face_planes.h"
#include "tests/compiler/viewsphere/sphere_samples.h"

namespace aspect {
namespace {

// From here on every face is as thick as a contour must be, and the border is known to a 32nd of
// an edge.
constexpr double kClear = 0.025;

// The faces that most of a cluster's patches see from their middle.
std::map<std::int32_t, VisibleFaces> faces_of_classes(const CompiledModel& model,
                                                      const std::vector<FacePlane>& planes) {
  std::map<std::int32_t, VisibleFaces> faces;
  for (std::size_t c = 0; c < model.clusters.size(); ++c) {
    std::map<VisibleFaces, int> votes;
    for (const PatchId id : model.clusters[c].patches) {
      const auto& corners = model.subdivision.sphere.patch(id).corners;
      Eigen::Vector3d middle(0, 0, 0);
      for (const VertexId corner : corners) middle += model.subdivision.direction(corner);
      ++votes[visible_faces(planes, middle.normalized())];
    }
    const auto fewer = [](const auto& a, const auto& b) { return a.second < b.second; };
    faces[static_cast<std::int32_t>(c)] =
        std::max_element(votes.begin(), votes.end(), fewer)->first;
  }
  return faces;
}

}  // namespace

TEST_CASE("divided patches of a cube see what the exact arrangement says, all over the sphere") {
  const CompiledModel& model = compiled_model("cube", 4);
  std::vector<Cluster> clusters = model.clusters;
  const SphereClasses classes = divide_borders(model.subdivision, model.options, clusters);
  REQUIRE(clusters.size() == 26);
  const std::vector<FacePlane> planes = face_planes(model.scene);
  const auto faces = faces_of_classes(model, planes);
  std::mt19937 random(5);
  int clear = 0, wrong = 0, divided = 0, unassigned = 0;
  for (int k = 0; k < 20000; ++k) {
    const Eigen::Vector3d direction = random_direction(random);
    const std::int32_t id = classes.at(model.subdivision.sphere, direction);
    unassigned += id == kNoClass ? 1 : 0;
    if (distance_to_nearest(planes, direction) < kClear) continue;
    ++clear;
    const PatchId leaf = model.subdivision.sphere.locate(direction);
    divided += classes.divisions.count(static_cast<std::uint32_t>(leaf)) > 0 ? 1 : 0;
    wrong += id == kNoClass || faces.at(id) != visible_faces(planes, direction) ? 1 : 0;
  }
  INFO(wrong << " wrong of " << clear << ", " << divided << " of them in divided patches");
  CHECK(clear > 12000);
  CHECK(divided > 1000);
  CHECK(wrong == 0);
  CHECK(unassigned < 100);
}

TEST_CASE("the area assigned is that of the pieces, and nearly all of the sphere") {
  for (const auto& name : {"cube", "l_shape"}) {
    const CompiledModel& model = compiled_model(name, 4);
    std::vector<Cluster> clusters = model.clusters;
    const SphereClasses classes = divide_borders(model.subdivision, model.options, clusters);
    double uniform = 0, assigned = 0;
    for (const Cluster& cluster : clusters) {
      uniform += cluster.area_fraction;
      assigned += cluster.area_assigned;
    }
    std::mt19937 random(6);
    int hits = 0;
    constexpr int kDirections = 20000;
    for (int k = 0; k < kDirections; ++k)
      hits += classes.at(model.subdivision.sphere, random_direction(random)) == kNoClass ? 0 : 1;
    INFO(name << ": " << uniform << " in uniform patches, " << assigned << " assigned");
    CHECK(assigned == Approx(static_cast<double>(hits) / kDirections).margin(0.005));
    CHECK(assigned > 0.985);
    CHECK(uniform < 0.85);
  }
}

TEST_CASE("views that join a cluster at its border are named like the views that they match") {
  const CompiledModel& model = compiled_model("cube", 4);  // no two faces alike
  std::vector<Cluster> clusters = model.clusters;
  divide_borders(model.subdivision, model.options, clusters);
  std::size_t joined = 0;
  for (std::size_t c = 0; c < model.clusters.size(); ++c) {
    const std::size_t before = model.clusters[c].views.size();
    const ClusterView& known = clusters[c].views.front();
    for (std::size_t i = before; i < clusters[c].views.size(); ++i) {
      const ClusterView& view = clusters[c].views[i];
      ++joined;
      // What a name shows on the object is the same surface in both views.
      const ObservedView &a = model.subdivision.views[place_of(known.vertex)],
                         &b = model.subdivision.views[place_of(view.vertex)];
      REQUIRE(view.names.size() == b.external_count);
      for (std::size_t p = 0; p < a.external_count; ++p)
        for (std::size_t q = 0; q < b.external_count; ++q)
          if (known.names[p] == view.names[q])
            CHECK(main_surface(a.contours[p]) == main_surface(b.contours[q]));
    }
  }
  CHECK(joined > 300);
}

TEST_CASE("without views to spend on borders nothing is divided") {
  CompileOptions options = options_of_level(3);
  options.border_views = 0;
  const Result<CompiledIndex> index =
      compile(model_scene("cube"), options, std::nullopt, {}, nullptr);
  REQUIRE(index.ok());
  CHECK(index.value().statistics.subdivision.border_views == 0);
}

}  // namespace aspect
