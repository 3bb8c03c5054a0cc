#include <catch2/catch.hpp>

#include "compiler/aspects/colour_separation.h"
#include "compiler/scene/mesh_scene.h"
#include "tests/compiler/aspects/symmetric_scenes.h"
#include "tests/tools/doctor/sick_meshes.h"
#include "tools/doctor/colour_checks.h"
#include "tools/doctor/colour_crowd.h"
#include "tools/doctor/colour_moves.h"
#include "tools/doctor/placement_checks.h"
#include "tools/doctor/visibility_checks.h"

namespace aspect {
namespace {

using Codes = std::vector<std::string>;
using Eigen::Vector3d;

const Vector3d kHalf(.2, .2, .2);
const Vector3d kNearRed(.84, .11, .1);  // of test_colour(0)

struct Patient {
  Scene scene;
  VisionParameters vision;

  Sight sight() const {
    const Result<Renderer> renderer = Renderer::create(scene);
    return look_around(scene, renderer.value(), colour_groups(scene), vision, 1);
  }
  std::vector<Finding> findings() const {
    const ColourGroups groups = colour_groups(scene);
    const Sight seen = sight();
    std::vector<Finding> all = check_colours(groups, vision);
    for (const auto& more :
         {check_borders(scene, groups, seen, vision), check_darkness(scene, groups, seen, vision),
          check_visibility(seen, vision, 1)})
      all.insert(all.end(), more.begin(), more.end());
    return all;
  }
};

void paint(Scene& scene, std::size_t surface, const Vector3d& colour) {
  scene.surfaces[surface].diffuse = scene.surfaces[surface].ambient = colour;
}

Patient block(const std::array<int, 6>& colours = {0, 1, 2, 3, 4, 5}) {
  return {block_scene(kHalf, colours), {}};
}

// A square on the +z face of the block, in white, which no face has.
void add_plate(Scene& scene, double half_x, double half_y) {
  scene.surfaces.push_back({{1, 1, 1}, {1, 1, 1}});
  const double z = kHalf.z() + 1e-4;
  scene.primitives.push_back({Polygon{{{-half_x, -half_y, z},
                                       {half_x, -half_y, z},
                                       {half_x, half_y, z},
                                       {-half_x, half_y, z}}},
                              static_cast<int>(scene.surfaces.size()) - 1});
}

}  // namespace

TEST_CASE("a block of six colours that are apart has nothing wrong with it") {
  CHECK(block().findings().empty());
}

TEST_CASE("touching colours that are too near are told with their difference and the step") {
  Patient sick = block();
  paint(sick.scene, 2, kNearRed);  // +y touches +x
  const auto findings = sick.findings();
  REQUIRE(codes_of(findings) == Codes{"inseparable_colours", "too_many_colours"});
  // Shares of 255: .85 / 1.05 against .84 / 1.05; the step is 8 + 3 * 255 / (255 * 1.05).
  CHECK(255 * .01 / 1.05 == Approx(2.43).margin(.01));
  CHECK(8 + 3 / 1.05 == Approx(10.86).margin(.005));
  const Finding& pair = finding_of(findings, "inseparable_colours");
  CHECK_THAT(pair.message, Catch::Contains("differ by 2.43, and a step of 10.86"));
  CHECK(pair.where == std::vector<std::size_t>{1, 3});
  CHECK_THAT(finding_of(findings, "too_many_colours").message,
             Catch::Contains("6 colours, of which 5 can be told apart"));
}

TEST_CASE("alike colours on opposite faces are too many, but no pair that touches") {
  Patient sick = block();
  paint(sick.scene, 1, kNearRed);  // -x is opposite to +x
  CHECK(codes_of(sick.findings()) == Codes{"too_many_colours"});
}

TEST_CASE("touching faces of one and the same colour are a note") {
  const auto findings = block({0, 1, 0, 3, 4, 5}).findings();
  REQUIRE(codes_of(findings) == Codes{"same_colour_touches"});
  CHECK(findings.front().severity == Severity::note);
  CHECK(findings.front().count == 1);
  CHECK(findings.front().where == std::vector<std::size_t>{1, 3});
}

TEST_CASE("greys that touch are one region although their brightness differs") {
  Patient sick = block();
  paint(sick.scene, 0, {.9, .9, .9});
  paint(sick.scene, 2, {.4, .4, .4});
  CHECK(codes_of(sick.findings()) == Codes{"inseparable_colours", "too_many_colours"});
  sick.vision = default_parameters(SensorKind::grey);
  for (std::size_t k = 0; k < 6; ++k)
    paint(sick.scene, k, Vector3d::Constant(.3 + .13 * static_cast<double>(k)));
  CHECK(codes_of(sick.findings()) == Codes{});
}

TEST_CASE("a surface darker than the background's limit is an error") {
  Patient sick = block();
  paint(sick.scene, 0, {.09, .04, .05});  // 255 * .18 = 45.9 of 48
  const auto findings = sick.findings();
  REQUIRE(codes_of(findings) == Codes{"dark_surface"});
  CHECK(findings.front().severity == Severity::error);
  CHECK_THAT(findings.front().message, Catch::Contains("of 46 at most"));
  paint(sick.scene, 0, {.099, .044, .055});
  CHECK(sick.findings().empty());
}

TEST_CASE("colours that are apart in full light may merge in the light of a coloured lamp") {
  Patient sick = block();
  paint(sick.scene, 0, {.5, .5, .2});
  paint(sick.scene, 2, {.5, .4, .2});
  CHECK(sick.findings().empty());
  sick.scene.studio.ambient = {.5, .5, .5};
  // Lights +x alone, which then shows .5 .4 .2 as well.
  sick.scene.lights.push_back({{5, 0, 0}, {.5, .3, .5}});
  bool found = false;
  for (const Finding& finding : sick.findings())
    found = found || finding.code == "merged_by_shading";
  CHECK(found);
}

TEST_CASE("colours are moved by the least that separates them, and healed so") {
  Patient sick = block();
  paint(sick.scene, 2, kNearRed);
  const ColourGroups groups = colour_groups(sick.scene);
  const auto moves = separate_colours(sick.scene, groups, sick.sight(), sick.vision);
  REQUIRE(moves.size() == 1);
  CHECK(moves[0].separation_before < 1);
  CHECK(moves[0].separation_after >= 1.25);
  CHECK(sick.findings().empty());
  // No colour of a lattice is much nearer and does as well, for either of the two.
  const double length = (moves[0].after - moves[0].before).norm();
  double least = 1;
  for (const std::size_t moved : {0U, 2U}) {
    const Vector3d before = moved == 0 ? test_colour(0) : kNearRed;
    const Vector3d other = moved == 0 ? kNearRed : test_colour(0);
    for (double r = 0; r <= 1; r += .02)
      for (double g = 0; g <= 1; g += .02)
        for (double b = 0; b <= 1; b += .02)
          if (colour_separation({r, g, b}, other, sick.vision) >= 1.25)
            least = std::min(least, (Vector3d(r, g, b) - before).norm());
  }
  CHECK(length < least + .01);
}

TEST_CASE("parts are found too small, too thin and hidden, as they are") {
  Patient sick = block();
  add_plate(sick.scene, .1, .1);
  CHECK(sick.findings().empty());
  Patient small = block();
  add_plate(small.scene, .006, .006);
  const auto too_small = small.findings();
  REQUIRE(codes_of(too_small) == Codes{"part_too_small"});
  CHECK(too_small.front().where == std::vector<std::size_t>{7});
  // From straight above: (2 * .006 * 192 / 2 / tan(22.5 deg) / .8)^2 = 12.1 pixels.
  CHECK_THAT(too_small.front().message,
             Catch::Contains("of 9 at most") || Catch::Contains("of 12 at most"));
  Patient thin = block();
  add_plate(thin.scene, .15, .007);  // 4 pixels of 5
  const auto too_thin = thin.findings();
  REQUIRE(codes_of(too_thin) == Codes{"part_too_thin"});
  Patient hidden = block();
  hidden.scene.primitives.push_back({Sphere{{0, 0, 0}, .1}, 5});
  CHECK(codes_of(hidden.findings()) == Codes{"part_hidden"});
}

TEST_CASE("an object off centre, out of the picture or lost in it is told by how much") {
  Scene scene = block_scene(kHalf, {0, 1, 2, 3, 4, 5});
  CHECK(check_place(scene, {}).empty());
  for (const double size : {.1, 2.0}) {
    const Scene sized = block_scene(size * kHalf, {0, 1, 2, 3, 4, 5});
    CHECK(codes_of(check_place(sized, {})) ==
          Codes{size < 1 ? "small_in_picture" : "leaves_picture"});
  }
  for (Primitive& primitive : scene.primitives)
    for (Vector3d& vertex : std::get<Polygon>(primitive.shape).vertices) vertex.x() -= .03;
  const auto findings = check_place(scene, {});
  REQUIRE(codes_of(findings) == Codes{"off_centre"});
  CHECK_THAT(findings.front().cure, Catch::Contains("translate it by 0.03 0 0"));
  const auto near = check_place(block_scene(kHalf, {0, 1, 2, 3, 4, 5}), {.5, 2, true});
  REQUIRE(codes_of(near) == Codes{"leaves_picture"});
  CHECK_FALSE(near.front().can_fix);
}

TEST_CASE("a file of metres that measures 80 is guessed to be in millimetres") {
  const ColouredMesh mesh = cuboid({-40, -30, -20}, {40, 30, 20});
  const auto metres = check_unit(mesh, true);
  REQUIRE(codes_of(metres) == Codes{"wrong_scale"});
  CHECK_THAT(metres.front().message, Catch::Contains("mm is likelier, 0.08 m"));
  CHECK(codes_of(check_unit(mesh, false)) == Codes{"unit_unknown"});
  CHECK(check_unit(cuboid({-.04, -.03, -.02}, {.04, .03, .02}), true).empty());
  CHECK(codes_of(check_unit(cuboid({-1e7, -1, -1}, {1e7, 1, 1}), false)) == Codes{"wrong_scale"});
  CHECK(codes_of(check_unit(cuboid({0, 0, 0}, {.1, .1, .1}), true)) == Codes{"origin_elsewhere"});
}

namespace {

struct Crowded {
  ColourGroups groups;
  ColourCrowd crowd;
};

Crowded crowd_of(const Patient& patient) {
  ColourGroups groups = colour_groups(patient.scene);
  ColourCrowd crowd = find_crowd(groups, patient.sight(), patient.vision);
  return {std::move(groups), std::move(crowd)};
}

}  // namespace

TEST_CASE("a shaded ball's colours are one crowd, on all of it, of as many paints as it has") {
  const Patient ball{scene_of_mesh(shaded_ball()).value(), {}};
  const auto [groups, crowd] = crowd_of(ball);
  CHECK(groups.groups.size() > 600);
  CHECK(crowd.is_one());
  CHECK(crowd.share > .98);
  CHECK(crowd.enough == ball_paints().size());
  const Finding finding = crowd_finding(crowd, groups, true, "ball.ply");
  CHECK_THAT(finding.message, Catch::Contains("100 % of the surface"));
  CHECK_THAT(finding.cure, Catch::Contains("aspectc doctor ball.ply --merge-colours 5"));
  CHECK_FALSE(finding.can_fix);
  CHECK(crowd_finding(crowd, groups, false, "ball.b").can_fix);
}

TEST_CASE("the share of a crowd is that of the surface that it is on") {
  // The caps in all their shades, the rest in two colours.
  ColouredMesh mesh = shaded_ball();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.part_of[t] != 4) mesh.colours[t] = ball_paints()[mesh.part_of[t] % 2];
  double caps = 0, whole = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const double area =
        (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
    whole += area;
    if (mesh.part_of[t] == 4) caps += area;
  }
  const auto [groups, crowd] = crowd_of({scene_of_mesh(mesh).value(), {}});
  CHECK(crowd.is_one());
  CHECK(crowd.share == Approx(caps / whole).margin(.05));
  CHECK(crowd.enough == 3);
}

TEST_CASE("a few pairs that are alike are no crowd") {
  Patient sick = block();
  paint(sick.scene, 2, kNearRed);
  const auto [groups, crowd] = crowd_of(sick);
  CHECK(crowd.pairs == 1);
  CHECK_FALSE(crowd.is_one());
  for (std::size_t k = 0; k < 6; ++k) CHECK_FALSE(crowd.has_primitive(groups, k));
}

}  // namespace aspect
