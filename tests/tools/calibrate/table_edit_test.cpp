// Values put into files that people have written.
#include <catch2/catch.hpp>

#include "tests/temporary_folder.h"
#include "tools/calibrate/output/table_edit.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;

TEST_CASE(
    "Values replace those that are there, comments stay, and new ones come last in their table") {
  const std::string before =
      "# mine\nindexes = [\"a.aspect\"]\n\n[camera]\nwidth = 640 # of all\n  fx=600\n\n"
      "[segmentation]\nchroma_step = 8\n";
  CHECK(with_values(before, "camera", {{"width", "1280"}, {"fx", "1200.5"}, {"cx", "3"}}) ==
        "# mine\nindexes = [\"a.aspect\"]\n\n[camera]\nwidth = 1280  # of all\nfx = 1200.5\ncx = "
        "3\n\n[segmentation]\nchroma_step = 8\n");
  CHECK(with_values(before, "segmentation", {{"noise_steps", "4"}}) ==
        before + "noise_steps = 4\n");
  CHECK(with_values("a = 1", "camera", {{"fx", "2"}}) == "a = 1\n\n[camera]\nfx = 2\n");
  CHECK(with_values("", "camera", {{"fx", "2"}}) == "[camera]\nfx = 2\n");
  // What only looks like the key, and another table of a longer name.
  CHECK(with_values("[camera]\n# fx = 1\n[camera.controls]\nfx = 5\n", "camera", {{"fx", "2"}}) ==
        "[camera]\n# fx = 1\nfx = 2\n[camera.controls]\nfx = 5\n");
}

TEST_CASE("A file that could not be read afterwards is left as it was") {
  const TemporaryFolder folder;
  const std::string broken = "[camera\nwidth = 640\n";
  const auto file = folder.write("broken.toml", broken);
  const auto done = put_values(file, "", "segmentation", {{"chroma_step", "8"}});
  REQUIRE_FALSE(done);
  CHECK_THAT(done.error(), Contains("broken.toml:1"));
  CHECK(read_file(file) == broken);
  CHECK_FALSE(put_values(folder / "new.toml", "", "segmentation", {{"chroma_step", "800"}}));
  CHECK_FALSE(std::filesystem::exists(folder / "new.toml"));
}

TEST_CASE("Configurations and projects take values, and are new where there is none") {
  const TemporaryFolder folder;
  const auto project = folder.write("part.toml", "scene = \"part.b\"\n[subdivision]\nlevel = 3\n");
  REQUIRE(put_values(project, "", "segmentation", {{"chroma_step", "12"}}));
  CHECK_THAT(read_file(project), Contains("level = 3\n\n[segmentation]\nchroma_step = 12\n"));
  REQUIRE(put_values(folder / "camera.toml", "# new\n", "segmentation", {{"chroma_step", "12"}}));
  CHECK(read_file(folder / "camera.toml") == "# new\n\n[segmentation]\nchroma_step = 12\n");
}

}  // namespace
}  // namespace aspect
