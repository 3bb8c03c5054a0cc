#include "tests/tools/report/report_cube.h"

#include <catch2/catch.hpp>

#include "tests/compiler/aspects/symmetric_scenes.h"

namespace aspect {

const Scene& cube_scene() {
  static const Scene scene = block_scene({.2, .2, .2}, {0, 1, 2, 3, 4, 5});
  return scene;
}

const CompileOptions& cube_options() {
  static const CompileOptions options = [] {
    CompileOptions o;
    o.level = 3;
    o.min_level = 3;
    return o;
  }();
  return options;
}

const LearntModel& cube_model() {
  static const Result<LearntModel> model =
      compile_model(cube_scene(), cube_options(), std::nullopt, {}, nullptr);
  REQUIRE(model.ok());
  return model.value();
}

}  // namespace aspect
