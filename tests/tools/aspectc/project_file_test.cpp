// Projects beyond the option table: objects, lamps, surfaces, meshes, hostile text.
#include "tools/aspectc/project/project_file.h"

#include <catch2/catch.hpp>

#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Contains;
using Catch::StartsWith;

std::string error_of(const std::string& text) {
  const Result<Project> project = parse_project(text, "folder/p.toml");
  return project ? "" : project.error();
}

}  // namespace

TEST_CASE("the least project is a scene, named from where the project is") {
  const Project project = parse_project("scene = \"a.b\"", "folder/p.toml").value();
  REQUIRE(project.objects.size() == 1);
  CHECK(project.objects[0].scene == "folder/a.b");
  CHECK(project.objects[0].name.empty());
  CHECK_FALSE(project.has_list);
  CHECK_FALSE(project.objects[0].settings.combined);
  CHECK(parse_project("scene = \"/x/a.b\"", "folder/p.toml").value().objects[0].scene == "/x/a.b");
}

TEST_CASE("what holds for all objects holds for each, unless it says otherwise") {
  const Project project = parse_project(R"(
[subdivision]
level = 4
stop_area = 0.9
[index]
combined = true
[[object]]
scene = "a.b"
[[object]]
name = "second"
scene = "b.b"
[object.subdivision]
level = 6
[[object.light.point]]
position = [1, 2, 3]
)",
                                        "p.toml")
                              .value();
  REQUIRE(project.objects.size() == 2);
  CHECK(project.has_list);
  const CompileSettings &first = project.objects[0].settings, &second = project.objects[1].settings;
  CHECK(first.options.level == 4);
  CHECK(second.options.level == 6);
  CHECK((first.options.stop_area == 0.9 && second.options.stop_area == 0.9));
  CHECK((first.combined && second.combined));
  CHECK(project.objects[1].name == "second");
  CHECK(first.light.lamps.empty());
  REQUIRE(second.light.lamps.size() == 1);
  CHECK(second.light.lamps[0].position == Eigen::Vector3d(1, 2, 3));
}

TEST_CASE("lamps, surfaces and the colours of a mesh's parts are read") {
  const Project project = parse_project(R"(
scene = "a.stl"
[light]
ambient = [0.1, 0.2, 0.3]
[[light.point]]
position = [1, 2, 3]
colour = [0.5, 0.5, 0.5]
shadows = false
[[surface]]
index = 2
diffuse = [1, 0, 0]
[[surface]]
colour = [0, 1, 0]
ambient = [0, 0, 1]
[mesh]
colours = {0 = [1, 0, 0], 12 = [0, 0.5, 0], "lid.face 3" = [0, 0, 1]}
)",
                                        "p.toml")
                              .value();
  const CompileSettings& settings = project.objects[0].settings;
  REQUIRE(settings.light.lamps.size() == 1);
  CHECK(settings.light.lamps[0].colour == Eigen::Vector3d(0.5, 0.5, 0.5));
  CHECK_FALSE(settings.light.lamps[0].shadows);
  REQUIRE(settings.surfaces.size() == 2);
  CHECK(settings.surfaces[0].index == 2);
  CHECK(settings.surfaces[0].place == "p.toml:9");
  CHECK(settings.surfaces[1].colour == Eigen::Vector3d(0, 1, 0));
  CHECK(settings.surfaces[1].ambient == Eigen::Vector3d(0, 0, 1));
  REQUIRE(settings.mesh.colours.size() == 3);
  CHECK(settings.mesh.colours.at("lid.face 3") == Eigen::Vector3d(0, 0, 1));
  CHECK(settings.mesh.colours.at("12") == Eigen::Vector3d(0, 0.5, 0));
}

TEST_CASE("what is wrong with a project is one line with file and line") {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "folder/p.toml:1: scene is missing"},
      {"scene = 3", "folder/p.toml:1: scene is 3; it must be a text"},
      {"scene = \"\"", "folder/p.toml:1: scene is no file"},
      {"scene = \"a\"\nscen = 1", "folder/p.toml:2: scen is not known here; did you mean scene?"},
      {"scene = \"a\"\nname = \"../x\"", "folder/p.toml:2: name is no name"},
      {"scene = \"a\"\nname = \"\"", "folder/p.toml:2: name is no name"},
      {"scene = \"a\"\n[[object]]\nscene = \"b\"", "folder/p.toml:1: scene and [[object]]"},
      {"[[object]]\nname = \"b\"", "folder/p.toml:1: [object] scene is missing"},
      {"[[object]]\nscene = \"b\"\n[object.index]\ncombined = true",
       "folder/p.toml:4: [object.index] combined holds for the whole project"},
      {"[[object]]\nscene = \"b\"\n[object.subdivision]\nlevl = 1",
       "folder/p.toml:4: [object.subdivision] levl is not known here; did you mean level?"},
      {"object = 1", "folder/p.toml:1: object is 1; it must be a list of tables, [[object]]"},
      {"object = [1]", "folder/p.toml:1: object is 1"},
      {"scene = \"a\"\nsubdivision = 1", "folder/p.toml:2: subdivision is 1; it must be a table"},
      {"scene = \"a\"\n[[surface]]\nindex = 1", "folder/p.toml:2: [[surface]] has no new colour"},
      {"scene = \"a\"\n[[surface]]\ndiffuse = [1, 1, 1]",
       "folder/p.toml:2: [[surface]] has neither index nor colour"},
      {"scene = \"a\"\n[[surface]]\nindex = 1\ncolour = [1, 1, 1]",
       "folder/p.toml:4: [surface] colour and index are given"},
      {"scene = \"a\"\n[[light.point]]\ncolour = [1, 1, 1]",
       "folder/p.toml:2: [light.point] position is missing"},
      {"scene = \"a\"\n[mesh]\ncolours = {0 = [1, 0]}", "folder/p.toml:3: [mesh.colours] 0 is"},
      {"scene = \"a\"\n\n= 1", "folder/p.toml:3: not TOML"},
      {"scene = \"a\n", "folder/p.toml:1: not TOML"},
  };
  for (const auto& [text, error] : cases) {
    INFO(text);
    CHECK_THAT(error_of(text), StartsWith(error));
    CHECK(error_of(text).find('\n') == std::string::npos);
  }
}

TEST_CASE("a segmentation table of a configuration will do, its frame's keys left out") {
  const std::string text =
      "scene = \"a\"\n[segmentation]\nregion_of_interest = [1, 2, 3, 4]\none_blob = true\n"
      "area_min_px = 77\n";
  const CompileSettings settings = parse_project(text, "p.toml").value().objects[0].settings;
  CHECK(settings.options.vision.area_min_px == 77);
  CHECK(settings.options.vision.region_of_interest.width == 0);
  CHECK_THAT(error_of("scene = \"a\"\n[segmentation]\none_blob = 1\n"), Contains("one_blob is 1"));
}

TEST_CASE("a project that is missing, a folder or too large is refused") {
  const TemporaryFolder folder;
  CHECK_THAT(read_project(folder.path() / "none.toml").error(), Contains("none.toml: cannot be"));
  CHECK_THAT(read_project(folder.path()).error(), Contains("cannot be read"));
  folder.write("large.toml", std::string((1U << 20U) + 1, '#'));
  CHECK_THAT(read_project(folder.path() / "large.toml").error(), Contains("too large"));
  folder.write("p.toml", "scene = \"a.b\"\n");
  CHECK(read_project(folder.path() / "p.toml").value().objects[0].scene == folder.path() / "a.b");
}

TEST_CASE("more objects than a bundle can hold are refused") {
  std::string text;
  for (std::size_t i = 0; i <= kMaxProjectObjects; ++i) text += "[[object]]\nscene = \"a\"\n";
  CHECK_THAT(error_of(text), Contains("object is there more than 64 times"));
}

}  // namespace aspect
