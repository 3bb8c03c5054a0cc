// Colours that a Bob scene names and that are not there.
#include <catch2/catch.hpp>

#include "compiler/scene/bob_reader.h"
#include "scene_samples.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Contains;
using Catch::StartsWith;
using Eigen::Vector3d;

const Vector3d kStandIn(.25, .5, .75);
constexpr std::string_view kBall = " sphere { center 0 0 0 radius .1 }\n";

Scene parsed(const std::string& text) {
  Result<Scene> scene = parse_bob(text, "s.b", {}, kStandIn);
  if (!scene) FAIL(scene.error());
  return std::move(scene).value();
}

}  // namespace

TEST_CASE("a colour that is not defined is told with its line and the nearest name") {
  const std::string text = "#define RED 1 0 0\nsurface { diffuse REED }" + std::string(kBall);
  CHECK_THAT(error_of(text), StartsWith("s.b:2: the colour 'REED' is not defined; #define it; the "
                                        "nearest name is 'RED', or go on with --missing-colour"));
  CHECK_THAT(error_of("surface { diffuse red }"), Contains("or #include the file that does"));
}

TEST_CASE("a given colour stands for those that are not defined, each told once") {
  const Scene scene = parsed("surface { diffuse red }" + std::string(kBall) +
                             "surface { diffuse 0.5 * red specular green }" + std::string(kBall) +
                             "surface { texture { checker red 0 0 0 } }" + std::string(kBall));
  REQUIRE(scene.surfaces.size() == 3);
  CHECK(scene.surfaces[0].diffuse == kStandIn);
  CHECK(scene.surfaces[0].ambient == kStandIn);
  CHECK(scene.surfaces[1].diffuse == .5 * kStandIn);
  CHECK(scene.surfaces[1].specular == kStandIn);
  CHECK(std::get<Checker>(scene.surfaces[2].texture->pattern).colors[0] == kStandIn);
  REQUIRE(scene.missing_colours.size() == 2);
  CHECK(line_of(scene.missing_colours[0]) == "s.b:1: the colour 'red' is not defined");
  CHECK(line_of(scene.missing_colours[1]) == "s.b:2: the colour 'green' is not defined");
}

TEST_CASE("the source of a scene with a colour that stands in gives the same scene") {
  const Scene scene = parsed("surface { diffuse red * 0.5 }" + std::string(kBall));
  const Result<Scene> again = parse_bob(scene.source, "s.b");
  if (!again) FAIL(again.error());
  CHECK(again.value().source == scene.source);
  CHECK(again.value().surfaces[0].diffuse == .5 * kStandIn);
}

TEST_CASE("a name where a number belongs stays an error") {
  const Result<Scene> scene = parse_bob("sphere { center x 0 0 radius .1 }", "s.b", {}, kStandIn);
  REQUIRE_FALSE(scene.ok());
  CHECK_THAT(scene.error(), Contains("'x' in place of a number"));
}

TEST_CASE("a given colour stands for a surface whose map is not there or is none") {
  const TemporaryFolder folder;
  folder.write("text.png", "not a picture");
  for (const std::string map : {"none.png", "text.png"}) {
    const auto file = folder.write(
        "s.b", "surface { diffuse 1 0 0 texture { map \"" + map + "\" } }" + std::string(kBall));
    CHECK_THAT(error_of_file(file),
               StartsWith(file.string() + ":1: ") && Contains(map) && Contains("--missing-colour"));
    const Result<Scene> scene = read_bob(file, {}, kStandIn);
    if (!scene) FAIL(scene.error());
    CHECK(scene.value().surfaces[0].diffuse == kStandIn);
    CHECK(scene.value().surfaces[0].texture == nullptr);
    REQUIRE(scene.value().missing_colours.size() == 1);
    CHECK_THAT(line_of(scene.value().missing_colours[0]), Contains(map));
  }
}

}  // namespace aspect
