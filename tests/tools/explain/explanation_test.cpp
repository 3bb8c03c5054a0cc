// Objects that are confusing by design, and one that is not.
#include "tools/explain/explanation.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "compiler/compile.h"
#include "compiler/scene/mesh_scene.h"
#include "tests/compiler/aspects/symmetric_scenes.h"
#include "tests/temporary_folder.h"
#include "tests/tools/doctor/sick_meshes.h"

namespace aspect {
namespace {

using Catch::Contains;

Explanation explained(const Scene& scene, int views = 200, int border_views = 20000) {
  const TemporaryFolder folder;
  CompileOptions options;
  options.level = options.min_level = 3;
  options.border_views = border_views;
  ExplainSettings settings;
  settings.views = views;
  const Result<Explanation> found =
      explain(folder.path() / "block.store", {scene, options}, settings);
  REQUIRE(found.ok());
  return found.value();
}

const Eigen::Vector3d kCube(.2, .2, .2);

std::set<std::size_t> faces_of_pair(const FaceConfusion& pair) {
  return {pair.face, pair.taken_for};
}

// A level that takes no time, at which every patch is uniform.
CompileOptions coarse_options() {
  CompileOptions options;
  options.level = options.min_level = 1;
  options.threshold = options.cluster_threshold = 1e9;
  options.small_cluster_fraction = 0;
  return options;
}

}  // namespace

TEST_CASE("a cube of six colours is not confused") {
  const Explanation e = explained(block_scene(kCube, {0, 1, 2, 3, 4, 5}));
  CHECK(e.wrong_views == 0);
  CHECK(e.confusions.empty());
  CHECK(e.face_confusions.empty());
  CHECK(e.failing_spots.empty());
  CHECK(e.cure.changes.empty());
  // Where one face alone is seen, four views look the same, the farthest 23 degrees apart.
  CHECK(e.accuracy.within_20_deg.share >= 0.98);
  CHECK(e.accuracy.rank_1.share > 0.85);
  CHECK(e.symmetries.empty());
}

TEST_CASE("two faces alike are named, and the colour proposed cures what they confuse") {
  const Explanation e = explained(block_scene(kCube, {4, 4, 0, 1, 2, 3}));
  CHECK(e.symmetries.empty());
  CHECK(e.wrong_views > 5);
  REQUIRE_FALSE(e.face_confusions.empty());
  CHECK(faces_of_pair(e.face_confusions.front()) == std::set<std::size_t>{0, 1});
  CHECK(10 * e.face_confusions.front().views >= 8 * e.wrong_views);
  CHECK(e.face_confusions.front().separation == Approx(0).margin(1e-9));
  REQUIRE(e.cure.changes.size() == 1);
  CHECK(std::set<std::size_t>{0, 1}.count(e.cure.changes[0].face) == 1);
  CHECK(e.cure.wrong_before == e.wrong_views);
  CHECK(e.cure.cured == e.wrong_views);
  CHECK(e.cure.wrong_after == 0);
  CHECK(e.cure.after.within_20_deg.share > e.accuracy.within_20_deg.high);
  std::size_t confused = 0;
  for (const AspectConfusion& c : e.confusions) confused += c.views;
  CHECK(confused == e.wrong_views);
  CHECK(e.confusions.front().aspect != e.confusions.front().taken_for);
}

TEST_CASE("an answer that differs by a symmetry is no error") {
  // Half turns about all axes are hidden: three views of four would be wrong without them.
  const Explanation e = explained(block_scene(kCube, {0, 0, 1, 1, 2, 2}));
  CHECK(e.symmetries.size() == 3);
  CHECK(e.wrong_views == 0);
  CHECK(e.cure.changes.empty());
}

TEST_CASE("blind spots have their share of the sphere, a place and a reason") {
  const Explanation e = explained(block_scene(kCube, {0, 1, 2, 3, 4, 5}), 20, 0);
  double share = 0;
  for (const Spot& spot : e.blind_spots) {
    share += spot.share;
    CHECK(spot.centre.norm() == Approx(1));
    CHECK(spot.radius_deg < 40);
    CHECK_FALSE(spot.reason.empty());
  }
  CHECK(e.blind_spots.size() > 1);
  CHECK(share <= e.blind_share + 1e-9);
  CHECK(e.blind_share > 0.1);  // at level 3 borders are broad, and here not divided
  CHECK(e.blind_share < 0.6);
}

TEST_CASE("intervals are Wilson's") {
  CHECK(share_of(0, 10).low == Approx(0).margin(1e-12));
  CHECK(share_of(0, 10).high == Approx(0.2775).epsilon(1e-3));
  CHECK(share_of(5, 10).low == Approx(0.2366).epsilon(1e-3));
  CHECK(share_of(5, 10).high == Approx(0.7634).epsilon(1e-3));
  CHECK(share_of(95, 100).low == Approx(0.8882).epsilon(1e-3));
}

TEST_CASE("the explanation is printed in words and as JSON, the same each time") {
  const Scene scene = block_scene(kCube, {4, 4, 0, 1, 2, 3});
  Explanation e = explained(scene, 60), again = explained(scene, 60);
  e.store = again.store = "block.store";
  CHECK(explanation_json(e) == explanation_json(again));
  const auto json = nlohmann::json::parse(explanation_json(e));
  CHECK(json.at("views") == 60);
  CHECK(json.at("accuracy").at("rank_1").at("share") == e.accuracy.rank_1.share);
  CHECK(json.at("wrong_views") == e.wrong_views);
  CHECK(json.at("confusions").size() == e.confusions.size());
  CHECK(json.at("cure").at("cured") == e.cure.cured);
  CHECK(json.at("face_confusions").at(0).at("face").at("surfaces").at(0) == 1);
  const std::string text = explanation_text(e);
  for (const char* words : {"accuracy to expect", "symmetry: none", "surface 2", "cure: paint",
                            "no aspect covers", "taken for"})
    CHECK_THAT(text, Contains(words));
}

TEST_CASE("colours that are common in the backgrounds are told of, with better ones") {
  const TemporaryFolder folder;
  const Scene scene = block_scene(kCube, {0, 1, 2, 3, 4, 5});
  CompileOptions options = coarse_options();
  ExplainSettings settings;
  settings.views = 5;
  settings.backgrounds = folder.path();
  const auto told = [&](SensorKind sensor) {
    options.vision.sensor = sensor;
    return explain(folder.path() / "block.store", {scene, options}, settings);
  };
  CHECK_THAT(told(SensorKind::colour).error(), Contains("holds no pictures"));
  const Eigen::Vector3d colour = 255 * test_colour(2);
  std::string ppm = "P6\n20 10\n255\n";
  for (int k = 0; k < 200; ++k)
    for (const double value : colour) ppm += static_cast<char>(static_cast<int>(value));
  folder.write("room.ppm", ppm);
  CHECK_THAT(told(SensorKind::range).error(), Contains("leave --backgrounds out"));
  const auto found = told(SensorKind::colour);
  if (!found) FAIL(found.error());
  REQUIRE(found.value().backgrounds);
  const BackgroundColour& first = found.value().backgrounds->colours.front();
  CHECK(first.face.primitives == std::vector<std::uint16_t>{3});
  CHECK(first.presence.pixels == 1);
  REQUIRE(first.better);
  CHECK_THAT(explanation_text(found.value()), Contains("colours in 1 pictures of ") &&
                                                  Contains("common      100.0 %  100.0 %") &&
                                                  Contains("better: " + first.better->paint.name));
  const auto json = nlohmann::json::parse(explanation_json(found.value()));
  CHECK(json["backgrounds"]["pictures"] == 1);
  CHECK(json["backgrounds"]["colours"][0]["commonness"] == "common");
  CHECK(json["backgrounds"]["colours"][0]["better"]["commonness"] == "rare");
  CHECK(json["backgrounds"]["colours"][5]["commonness"] == "rare");
}

TEST_CASE("of a mesh in very many colours the cure is to merge them, to as many as it has paints") {
  Scene scene = scene_of_mesh(shaded_ball()).value();
  scene.file = "ball.ply";
  const CompileOptions options = coarse_options();
  ExplainSettings settings;
  settings.views = 10;
  const TemporaryFolder folder;
  const auto found = explain(folder.path() / "ball.store", {scene, options}, settings);
  if (!found) FAIL(found.error());
  const Explanation& e = found.value();
  REQUIRE(e.crowded);
  CHECK(e.crowded->colours == scene.surfaces.size());
  CHECK(e.crowded->share > .98);
  CHECK(e.crowded->enough == ball_paints().size());
  CHECK(e.cure.changes.empty());
  CHECK_THAT(explanation_text(e),
             Contains("cure: merge the mesh's ") && Contains("aspectc ball.ply --merge-colours 5"));
  CHECK(nlohmann::json::parse(explanation_json(e))["crowded_colours"]["merge_colours"] == 5);
}

TEST_CASE("the cure of a mesh in merged colours says what they were merged into") {
  Explanation e;
  e.faces = {{{1}, {1, 0, 0}}};
  e.cure.changes = {{0, {0, 1, 0}, "green", 3}};
  CHECK_THAT(explanation_text(e), !Contains("merge_colours"));
  e.merged_colours = 6;
  CHECK_THAT(explanation_text(e), Contains("merge_colours = 6 under [mesh]"));
  CHECK(nlohmann::json::parse(explanation_json(e))["merged_colours"] == 6);
}

}  // namespace aspect
