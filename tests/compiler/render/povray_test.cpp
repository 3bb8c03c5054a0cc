// Our pictures of scenes with everything that Bob's language has against POV-Ray's, where both
// renderers mean the same. Skipped where povray is not installed. With ASPECT_POVRAY_DUMP set to a
// folder, both pictures of every scene are written there, side by side.
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "compiler/scene/bob_reader.h"
#include "tests/compiler/render/pov_scene.h"
#include "tests/compiler/render/test_scenes.h"
#include "tests/temporary_folder.h"

using namespace aspect;
using Eigen::Vector3d;

namespace {

constexpr const char* kStudio =
    "studio { at 0 0 -.05 up 0 0 1 angle 50 resolution 160 120 background .3 .4 .6 "
    "ambient .2 .2 .2 no_exp_trans ";
constexpr const char* kFloor =
    "polygon { points 4 vertex -.4 -.4 -.2 vertex .4 -.4 -.2 vertex .4 .4 -.2 vertex -.4 .4 -.2 } ";
constexpr const char* kBalls =
    "surface { diffuse .8 .3 .2 } sphere { center .1 -.1 -.1 radius .1 } "
    "surface { diffuse .2 .7 .4 } cone { base -.1 .1 -.2 base_radius .1 apex -.1 .1 .1 "
    "apex_radius .03 } ring { center -.1 .1 .1 normal 0 0 1 radius .03 } ";
constexpr const char* kLamp = "light { position .5 -.3 .8 color .7 .7 .6 } ";
constexpr const char* kChecker =
    "surface { diffuse .9 .8 .7 texture { checker 1 1 1 .1 .2 .3 scale .11 translate .03 .02 -.2 } "
    "} ";

struct Difference {
  double mean = 0;      // of all channels, in 255ths, inside of surfaces
  int pixels = 0;       // compared
  int stray_edges = 0;  // with no edge within one pixel in the other picture
  int edges = 0;
};

int difference(const std::vector<std::uint8_t>& rgb, std::size_t a, std::size_t b) {
  int worst = 0;
  for (std::size_t c = 0; c < 3; ++c)
    worst = std::max(worst, std::abs(int{rgb[3 * a + c]} - int{rgb[3 * b + c]}));
  return worst;
}

// Where a pixel differs from its right or lower neighbour by more than the step.
std::vector<bool> edges_of(const std::vector<std::uint8_t>& rgb, int width, int height, int step) {
  std::vector<bool> edges(rgb.size() / 3);
  for (int y = 0; y + 1 < height; ++y)
    for (int x = 0; x + 1 < width; ++x) {
      const auto k = static_cast<std::size_t>(y * width + x);
      edges[k] = difference(rgb, k, k + 1) > step ||
                 difference(rgb, k, k + static_cast<std::size_t>(width)) > step;
    }
  return edges;
}

template <typename Wanted>
bool any_around(int x, int y, int width, int height, Wanted wanted) {
  for (int row = std::max(y - 1, 0); row <= std::min(y + 1, height - 1); ++row)
    for (int column = std::max(x - 1, 0); column <= std::min(x + 1, width - 1); ++column)
      if (wanted(static_cast<std::size_t>(row * width + column))) return true;
  return false;
}

void count_stray_edges(const std::vector<std::uint8_t>& from, const std::vector<std::uint8_t>& to,
                       int width, int height, Difference& result) {
  constexpr int kClear = 30, kFaint = 8;
  const std::vector<bool> clear = edges_of(from, width, height, kClear);
  const std::vector<bool> faint = edges_of(to, width, height, kFaint);
  for (int y = 0; y + 1 < height; ++y)
    for (int x = 0; x + 1 < width; ++x) {
      if (!clear[static_cast<std::size_t>(y * width + x)]) continue;
      ++result.edges;
      if (!any_around(x, y, width, height, [&](std::size_t k) { return faint[k]; }))
        ++result.stray_edges;
    }
}

Difference difference_of(const Picture& ours, const PovPicture& theirs) {
  const int width = ours.width_px, height = ours.height_px;
  Difference result;
  double sum = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto k = static_cast<std::size_t>(y * width + x);
      if (any_around(x, y, width, height,
                     [&](std::size_t n) { return ours.surface[n] != ours.surface[k]; }))
        continue;
      ++result.pixels;
      for (std::size_t c = 3 * k; c < 3 * k + 3; ++c)
        sum += std::abs(int{ours.rgb[c]} - int{theirs.rgb[c]});
    }
  result.mean = sum / (3 * result.pixels);
  count_stray_edges(ours.rgb, theirs.rgb, width, height, result);
  count_stray_edges(theirs.rgb, ours.rgb, width, height, result);
  return result;
}

void dump(const std::string& name, const Picture& ours, const PovPicture& theirs) {
  const char* folder = std::getenv("ASPECT_POVRAY_DUMP");
  if (folder == nullptr) return;
  cv::Mat both(ours.height_px, 3 * ours.width_px, CV_8UC3);
  for (int y = 0; y < ours.height_px; ++y)
    for (int x = 0; x < ours.width_px; ++x)
      for (int c = 0; c < 3; ++c) {
        const auto k = static_cast<std::size_t>(3 * (y * ours.width_px + x) + 2 - c);
        both.at<cv::Vec3b>(y, x)[c] = ours.rgb[k];
        both.at<cv::Vec3b>(y, x + ours.width_px)[c] = theirs.rgb[k];
        both.at<cv::Vec3b>(y, x + 2 * ours.width_px)[c] = static_cast<std::uint8_t>(
            std::min(255, 10 * std::abs(int{ours.rgb[k]} - int{theirs.rgb[k]})));
      }
  cv::imwrite((std::filesystem::path(folder) / (name + ".png")).string(), both);
}

Scene scene_of(const std::string& text) {
  Result<Scene> scene = parse_bob(
      text, std::filesystem::path(ASPECT_SOURCE_DIR) / "tests" / "data" / "scenes" / "test.b");
  if (!scene) FAIL(scene.error());
  return std::move(scene).value();
}

struct Limits {
  double mean = 0.05;      // 255ths; without sampling 0.008 at most was measured
  double stray_share = 0;  // of the edge pixels
};

void require_like_povray(const std::string& name, const Scene& scene, const Limits& limits = {},
                         const std::string& options = {}) {
  if (!povray_is_installed()) {
    WARN("skipped: povray is not installed; tools/setup.sh installs it");
    return;
  }
  const TemporaryFolder scratch;
  const Camera camera = camera_at(scene.studio, Vector3d(.55, -1, .6).normalized());
  Picture ours;
  renderer_of(scene).render(camera, ours);
  const auto theirs = pov_picture(scene, camera, scratch.path(), options);
  REQUIRE(theirs.has_value());
  dump(name, ours, *theirs);
  const Difference found = difference_of(ours, *theirs);
  INFO(name << ": mean " << found.mean << " of " << found.pixels << " pixels, " << found.stray_edges
            << " of " << found.edges << " edges stray");
  if (std::getenv("ASPECT_POVRAY_DUMP") != nullptr)
    WARN(name << ": mean " << found.mean << " of " << found.pixels << " pixels, "
              << found.stray_edges << " of " << found.edges << " edges stray");
  CHECK(found.pixels > ours.width_px * ours.height_px / 2);
  CHECK(found.edges > 100);
  CHECK(found.mean <= limits.mean);
  CHECK(found.stray_edges <= limits.stray_share * found.edges);
}

void require_like_povray(const std::string& name, const std::string& text,
                         const Limits& limits = {}, const std::string& options = {}) {
  require_like_povray(name, scene_of(text), limits, options);
}

std::string matte_scene(const std::string& studio, const std::string& light) {
  return kStudio + studio + " } " + light + "surface { diffuse .8 .8 .8 } " + kFloor + kBalls;
}

}  // namespace

TEST_CASE("point lights and their shadows are POV-Ray's") {
  require_like_povray("point", matte_scene("", kLamp));
}

TEST_CASE("directional light is POV-Ray's parallel light") {
  require_like_povray(
      "directional",
      matte_scene("", "light { type directional direction -1 .4 -1 color .8 .8 .8 }"));
}

TEST_CASE("the soft shadow of a spherical light is that of POV-Ray's round area light") {
  require_like_povray("spherical",
                      matte_scene("",
                                  "light { type spherical center .4 -.3 .6 radius .15 samples "
                                  "256 color .8 .8 .8 }"),
                      {0.25});
}

TEST_CASE("light falls off with the distance as POV-Ray's, once or squared") {
  require_like_povray("falloff1",
                      matte_scene("", "light { position .3 -.2 .4 falloff 1 color .3 .3 .3 } "));
  require_like_povray("falloff2",
                      matte_scene("", "light { position .3 -.2 .4 falloff 2 color .2 .2 .2 } "));
}

TEST_CASE("a spot lights what POV-Ray's does") {
  require_like_povray("spot", matte_scene("",
                                          "light { position .2 -.2 .7 at 0 0 -.2 min_angle 30 "
                                          "max_angle 30 color .8 .8 .8 } "));
}

TEST_CASE("an orthogonal picture is POV-Ray's") {
  require_like_povray("orthogonal", matte_scene("project flat .9", kLamp));
}

TEST_CASE("a mirror shows what POV-Ray's shows, in another mirror too") {
  require_like_povray(
      "mirror", kStudio + std::string("} ") + kLamp + kChecker + kFloor +
                    "surface { diffuse .1 .1 .1 specular .8 .7 .6 } "
                    "polygon { points 4 vertex -.35 .35 -.2 vertex .2 .35 -.2 vertex .2 .35 .15 "
                    "vertex -.35 .35 .15 } sphere { center .15 .1 -.08 radius .12 } " +
                    kBalls);
}

TEST_CASE("glass bends light as POV-Ray's does, and tints it") {
  const std::string before = kStudio + std::string("} ") + kLamp + kChecker + kFloor;
  require_like_povray("glass", before +
                                   "surface { diffuse 0 0 0 ambient 0 0 0 transparent 1 1 1 ior "
                                   "1.5 } sphere { center 0 0 -.05 radius .14 }");
  require_like_povray("tinted", before +
                                    "surface { diffuse 0 0 0 ambient 0 0 0 transparent .9 .5 .3 "
                                    "ior 1.3 } sphere { center 0 0 -.05 radius .14 }");
}

TEST_CASE("light fades inside of glass with the length of its way as in POV-Ray") {
  Scene scene = scene_of(kStudio + std::string("} ") + kLamp + kChecker + kFloor +
                         "surface { diffuse 0 0 0 ambient 0 0 0 transparent .5 .1 .02 ior 1.2 } "
                         "sphere { center 0 0 -.05 radius .14 }");
  scene.studio.exponential_transparency = true;
  require_like_povray("fading", scene);
}

TEST_CASE("a checkered cube and a picture on a rectangle are POV-Ray's") {
  require_like_povray(
      "textures",
      kStudio + std::string("} ") + kLamp +
          "surface { diffuse 1 1 1 texture { map \"tiles.png\" scale .5 .25 1 rotate 0 0 30 } "
          "} " +
          kFloor +
          "transform { rotate 10 20 30 translate .02 0 0 } surface { diffuse .9 .8 .7 texture { "
          "checker 1 .9 .2 .3 .1 .2 scale .05 translate .013 .017 .011 } } "
          "sphere { center 0 0 -.02 radius .15 } transform_pop");
}

TEST_CASE("a highlight is POV-Ray's Phong") {
  require_like_povray("highlight", kStudio + std::string("} ") + kLamp +
                                       "surface { diffuse .5 .1 .1 shine 20 .5 .5 .5 } " + kFloor +
                                       "sphere { center 0 0 -.05 radius .15 } surface { diffuse "
                                       ".1 .1 .5 shine 5 .4 .4 .4 } cylinder { base .2 .2 -.2 apex "
                                       ".2 .2 .1 radius .07 }");
}

TEST_CASE("smooth triangles are shaded as POV-Ray's") {
  require_like_povray(
      "smooth",
      kStudio + std::string("} ") + kLamp + "surface { diffuse .8 .8 .8 } " + kFloor +
          "surface { diffuse .3 .5 .9 shine 10 .4 .4 .4 } "
          "\n#define TIP vertex 0 0 .2 normal 0 0 1\n"
          "#define A vertex .25 0 -.15 normal 1 0 .5\n#define B vertex 0 .25 -.15 normal 0 1 .5\n"
          "#define C vertex -.25 0 -.15 normal -1 0 .5\n#define D vertex 0 -.25 -.15 normal 0 -1 "
          ".5\npatch { A B TIP } patch { B C TIP } patch { C D TIP } patch { D A TIP }");
}

TEST_CASE("haze is POV-Ray's fog") {
  require_like_povray("haze", matte_scene("haze .4", kLamp));
}

// Where POV-Ray has 81 samples a pixel, every border is its share of both sides.
TEST_CASE("antialiased pixels are those of POV-Ray at its finest") {
  const std::string finest = "+A0.0 +AM1 +R9 -J";
  const std::string scene = matte_scene("resolution 80 60 antialias adaptive threshold 0", kLamp);
  std::string text = scene;
  text.replace(text.find("resolution 160 120 "), 19, "");
  require_like_povray("antialias", text, {0.3}, finest);
}

TEST_CASE("a scene with all of it together is POV-Ray's, smooth borders included") {
  const auto file =
      std::filesystem::path(ASPECT_SOURCE_DIR) / "tests" / "data" / "scenes" / "showcase.b";
  Result<Scene> scene = read_bob(file);
  if (!scene) FAIL(scene.error());
  CHECK(scene.value().warnings == std::vector<std::string>{});
  scene.value().studio.width_px = 160;
  scene.value().studio.height_px = 120;
  require_like_povray("showcase", scene.value(), {0.7}, "+A0.05 +AM2 +R2 -J");
}
