// What settings do to a scene: camera, light, surfaces, distances.
#include <catch2/catch.hpp>
#include <cmath>

#include "compiler/render/renderer.h"
#include "compiler/scene/bob_reader.h"
#include "tools/aspectc/options/option_text.h"
#include "tools/aspectc/project/distance_check.h"
#include "tools/aspectc/project/init_text.h"
#include "tools/aspectc/project/project_file.h"
#include "tools/aspectc/project/scene_settings.h"

namespace aspect {
namespace {

using Catch::Contains;
using Catch::StartsWith;

// A large red square facing +x, and in front of it a small green one, 0.02 wide.
constexpr const char* kScene = R"(
studio { at 0 0 0 up 0 0 1 angle 50 resolution 160 120 ambient 1 1 1 }
surface { diffuse .8 .1 .1 }
polygon { points 4 vertex 0 -.2 -.2 vertex 0 .2 -.2 vertex 0 .2 .2 vertex 0 -.2 .2 }
surface { diffuse .1 .8 .1 ambient .2 .8 .1 }
polygon { points 4 vertex .1 -.01 -.01 vertex .1 .01 -.01 vertex .1 .01 .01 vertex .1 -.01 .01 }
)";

Scene scene() {
  return parse_bob(kScene, "part.b").value();
}

CompileSettings settings_of(const std::string& text) {
  const Result<Project> project = parse_project("scene = \"part.b\"\n" + text, "p.toml");
  if (!project) FAIL(project.error());
  return project.value().objects.front().settings;
}

Scene with(const std::string& text) {
  Scene changed = scene();
  const auto done = apply_settings(settings_of(text), changed);
  if (!done) FAIL(done.error());
  return changed;
}

Picture picture_of(const Scene& shown) {
  Picture picture;
  Renderer::create(shown).value().render(camera_at(shown.studio, {1, 0, 0}), picture);
  return picture;
}

// Of a surface's pixels, and how many they are.
struct Spot {
  double x = 0, y = 0, pixels = 0;
};
Spot spot_of(const Picture& picture, int surface) {
  Spot spot;
  for (int y = 0; y < picture.height_px; ++y)
    for (int x = 0; x < picture.width_px; ++x) {
      const auto place = static_cast<std::size_t>(y * picture.width_px + x);
      if (picture.surface[place] != surface) continue;
      spot.x += x;
      spot.y += y;
      spot.pixels += 1;
    }
  spot.x /= spot.pixels;
  spot.y /= spot.pixels;
  return spot;
}

}  // namespace

TEST_CASE("settings that say what the scene says leave it as it is, its source too") {
  const Scene same = with(
      "[camera]\nwidth = 160\nheight = 120\nfield_of_view_deg = 50\ndistance = [1, 1]\n"
      "[light]\nambient = [1, 1, 1]\n[[surface]]\nindex = 0\ndiffuse = [0.8, 0.1, 0.1]\n");
  CHECK(same.source == scene().source);
  CHECK(picture_of(same).rgb == picture_of(scene()).rgb);
}

TEST_CASE("settings that change anything of the scene change its source, each otherwise") {
  std::vector<std::string> sources = {scene().source};
  for (const char* text :
       {"[camera]\nwidth = 161", "[camera]\nheight = 121", "[camera]\nfield_of_view_deg = 51",
        "[camera]\nfx = 200\nfy = 200", "[camera]\nfx = 200\nfy = 200\ncx = 70",
        "[camera]\ndistance = [1, 2]", "[light]\nambient = [1, 1, 0.5]",
        "[[light.point]]\nposition = [1, 2, 3]", "[[surface]]\nindex = 0\ndiffuse = [0, 0, 1]",
        "[[surface]]\nindex = 1\nambient = [0, 0, 1]"}) {
    const std::string source = with(text).source;
    INFO(text);
    CHECK(std::find(sources.begin(), sources.end(), source) == sources.end());
    sources.push_back(source);
  }
}

TEST_CASE("focal lengths and principal point are where the picture shows them") {
  const Scene shifted =
      with("[camera]\nwidth = 320\nheight = 240\nfx = 400\nfy = 200\ncx = 100\ncy = 150\n");
  const Spot spot = spot_of(picture_of(shifted), 1);
  // The camera is 1 away from a square of 0.4.
  CHECK(spot.x == Approx(100).margin(0.6));
  CHECK(spot.y == Approx(150).margin(0.6));
  CHECK(spot.pixels == Approx(160 * 80).epsilon(0.02));
  CHECK(shifted.studio.angle_deg == Approx(360 / M_PI * std::atan(160 / 400.0)));
  const Intrinsics in = intrinsics_of(shifted.studio);
  CHECK((in.fx_px == 400 && in.fy_px == 200 && in.cx_px == 100 && in.cy_px == 150));
}

TEST_CASE("another size of the picture keeps the shape of pixels and the field of view") {
  const Scene wide = with("[camera]\nwidth = 320\n");
  const Intrinsics before = intrinsics_of(scene().studio), after = intrinsics_of(wide.studio);
  CHECK(before.fx_px == Approx(before.fy_px));
  CHECK(after.fx_px == Approx(after.fy_px));
  CHECK(after.fx_px == Approx(2 * before.fx_px));
}

TEST_CASE("a range of distances is compiled at its geometric mean") {
  const Scene far = with("[camera]\ndistance = [1, 4]\n");
  CHECK(far.studio.distance == Approx(2));
  const double once = spot_of(picture_of(scene()), 1).pixels;
  CHECK(spot_of(picture_of(far), 1).pixels == Approx(once / 4).epsilon(0.05));
}

TEST_CASE("light and surfaces are what the project says, found by index or by colour") {
  const Scene lit = with(
      "[light]\nambient = [0.5, 0.5, 0.5]\n[[light.point]]\nposition = [1, 2, 3]\n"
      "colour = [0.1, 0.2, 0.3]\nshadows = false\n");
  CHECK(lit.studio.ambient == Eigen::Vector3d(0.5, 0.5, 0.5));
  REQUIRE(lit.lights.size() == 1);
  CHECK(lit.lights[0].position == Eigen::Vector3d(1, 2, 3));
  CHECK(lit.lights[0].color == Eigen::Vector3d(0.1, 0.2, 0.3));
  CHECK_FALSE(lit.lights[0].casts_shadows);
  // Two surfaces change places; an ambient colour that was the diffuse one goes with it.
  const Scene swapped = with(
      "[[surface]]\ncolour = [0.8, 0.1, 0.1]\ndiffuse = [0.1, 0.8, 0.1]\n"
      "[[surface]]\ncolour = [0.1, 0.8, 0.1]\ndiffuse = [0.8, 0.1, 0.1]\n");
  CHECK(swapped.surfaces[0].diffuse == Eigen::Vector3d(0.1, 0.8, 0.1));
  CHECK(swapped.surfaces[0].ambient == Eigen::Vector3d(0.1, 0.8, 0.1));
  CHECK(swapped.surfaces[1].diffuse == Eigen::Vector3d(0.8, 0.1, 0.1));
  CHECK(swapped.surfaces[1].ambient == Eigen::Vector3d(0.2, 0.8, 0.1));
}

TEST_CASE("a surface that is not there is an error with its line") {
  Scene changed = scene();
  CHECK_THAT(
      apply_settings(settings_of("[[surface]]\nindex = 2\ndiffuse = [0, 0, 0]\n"), changed).error(),
      StartsWith("p.toml:2: [[surface]] index is 2; the scene has surfaces 0 to 1"));
  CHECK_THAT(
      apply_settings(settings_of("\n[[surface]]\ncolour = [1, 1, 1]\ndiffuse = [0, 0, 0]\n"),
                     changed)
          .error(),
      StartsWith("p.toml:3: [[surface]] colour is that of no surface; there are [0.8, 0.1, 0.1]"));
}

TEST_CASE("a range that begins too near or ends too far is a warning with numbers") {
  const Scene part = scene();
  // The square's corners are 0.2 sqrt(2) from the middle; the picture's height is the narrower
  // side.
  const double tangent = 60 / intrinsics_of(part.studio).fy_px;
  CHECK(fitting_radius_at(part.studio, 2) == Approx(2 * std::sin(std::atan(tangent))));
  VisionParameters vision;
  vision.area_min_px = 5;
  const double nearest = 0.2 * std::sqrt(2.0) / std::sin(std::atan(tangent));
  CHECK(distance_warnings(part, vision, 1.001 * nearest, 1.001 * nearest).empty());
  const auto near = distance_warnings(part, vision, 0.99 * nearest, 1);
  REQUIRE(near.size() == 1);
  CHECK_THAT(near[0], StartsWith("part: the object leaves the picture at distance"));
  // Face-on the small square has (0.02 fx / 0.9)^2 pixels from 1 away: 14.
  const SmallestContour smallest = smallest_contour_at(part, vision, 1);
  CHECK(smallest.surface == 2);
  CHECK(smallest.area_px == Approx(14).margin(5));
  const auto far = distance_warnings(part, vision, 1, 3);
  REQUIRE(far.size() == 1);
  CHECK_THAT(far[0], StartsWith("part: at distance 3 the smallest contour (of surface 2) has") &&
                         Contains("area_min_px 5"));
}

TEST_CASE("a written project has every key, and each is at what it would be without it") {
  const std::string text = init_text("part.b", scene());
  CHECK(parse_project(text, "p.toml").ok());
  for (const Option& option : compile_option_table()) {
    // Alone but for those that go together.
    std::string commented = text;
    std::vector<std::string> keys = {std::string(option.text.key)};
    if (option.text.table == "camera" && option.text.key.size() == 2)
      keys = {"fx", "fy", "cx", "cy"};
    for (const std::string& key : keys) {
      const std::size_t place = commented.find(
          "\n# " + key + " = ", commented.find("\n[" + std::string(option.text.table) + "]\n"));
      INFO(key_name(option));
      REQUIRE(place != std::string::npos);
      commented.erase(place + 1, 2);
    }
    const Result<Project> project = parse_project(commented, "p.toml");
    if (!project) FAIL(project.error());
    const CompileSettings& settings = project.value().objects[0].settings;
    if (option.text.table == "run") continue;
    if (option.get({})) CHECK(option.get(settings) == option.get({}));
    Scene same = scene();
    REQUIRE(apply_settings(settings, same).ok());
    INFO(key_name(option));
    CHECK(same.source == scene().source);
    CHECK(same.studio.angle_deg == scene().studio.angle_deg);
  }
}

TEST_CASE(
    "a written project with all of its lines in force is read, but for the choices it offers") {
  std::string text = init_text("a \"quoted\" \\ name.b", scene());
  CHECK(parse_project(text, "p.toml").value().objects[0].scene == "a \"quoted\" \\ name.b");
  for (const char* line :
       {"name = \"part\"", "[[light.point]]", "position = [2, 2, 2]", "colour = [1, 1, 1]",
        "[[surface]]", "diffuse = [0.8, 0.1, 0.1]", "ambient = [0.2, 0.8, 0.1]",
        "colours = {0 = [1, 0, 0], lid = [0, 1, 0], \"lid.face 3\" = [0, 0, 1]}", "[[object]]"})
    CHECK_THAT(text, Contains(std::string("\n# ") + line + "\n"));
  CHECK_THAT(text, Contains("\n[mesh]\n"));
}

}  // namespace aspect
