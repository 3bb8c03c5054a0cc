// From a STEP file to an index that knows its faces.
#include <catch2/catch.hpp>

#include "tests/compiler/step/step_samples.h"
#include "tests/temporary_folder.h"
#include "tests/tools/aspectc/run_aspectc.h"

namespace aspect {

TEST_CASE("aspectc compiles a STEP file, and inspect names its faces") {
  const TemporaryFolder folder;
  write_step_box(folder / "box.step", StepSchema::ap214);
  const Outcome compiled = run_aspectc(
      folder.path(),
      {"box.step", "--level", "1", "--no-store", "--chord-error", "0.002", "-o", "box.aspect"});
  INFO(compiled.err);
  REQUIRE(compiled.exit_code == 0);
  CHECK(compiled.out.find("STEP") == std::string::npos);  // what OpenCASCADE prints
  const Outcome inspected = run_aspectc(folder.path(), {"inspect", "box.aspect"});
  for (const BoxFace& face : box_faces())
    CHECK(inspected.out.find(": " + face.name + "\n") != std::string::npos);
}

}  // namespace aspect
