#include <catch2/catch.hpp>

#include "compiler/scene/scene_reader.h"
#include "tests/temporary_folder.h"

namespace aspect {

TEST_CASE("a program without the module says in one line what it takes to read STEP") {
  const TemporaryFolder folder;
  const auto file = folder.write("part.STP", "ISO-10303-21;\n");
  const Result<Scene> scene = read_scene(file);
  REQUIRE_FALSE(scene.ok());
  CHECK(scene.error().find(file.string() + ": this build reads no STEP; install libocct") == 0);
  CHECK(scene.error().find('\n') == std::string::npos);
}

}  // namespace aspect
