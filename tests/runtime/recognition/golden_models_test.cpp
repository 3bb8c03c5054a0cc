// The test at power-on on indexes of many objects, just compiled.
#include <catch2/catch.hpp>

#include "compiler/index/golden_choice.h"
#include "compiler/scene/bob_reader.h"
#include "runtime/recognition/self_test.h"
#include "tests/compiler/aspects/compiled_model.h"

namespace aspect {
namespace {

using Catch::Contains;
using Catch::StartsWith;
using Outcome = SelfTestResult::Outcome;

ClassIndex index_of(const Scene& scene, const CompileOptions& options) {
  const std::vector<std::uint8_t> bytes = index_bytes_of(scene, options);
  return parse_index(std::as_bytes(std::span(bytes)), scene.name).value();
}

}  // namespace

TEST_CASE("every object of the demo answers its own golden frame") {
  for (const std::string name : {"cube", "l_shape", "blockcyl1", "blockcyl2", "pegblock"}) {
    Scene scene = read_bob(ASPECT_SOURCE_DIR "/tests/data/rendered/" + name + ".b").value();
    scene.studio.width_px = scene.studio.height_px = 256;
    const ClassIndex index = index_of(scene, options_of_level(2));
    INFO(name);
    REQUIRE(index.golden);
    CHECK(golden_bytes(*index.golden) <= kMostGoldenBytes);
    CHECK(index.golden->matched == index.golden->regions);
    CHECK(index.golden->matched > 1);
    CHECK(index.golden->score > 0.5F);
    const SelfTestResult result = self_test(index);
    INFO(result.line);
    CHECK(result.outcome == Outcome::passed);
    CHECK_THAT(result.line, StartsWith(name + ": self test: passed"));
  }
}

TEST_CASE("an object in several pieces has a golden frame") {
  const Scene scene = read_bob(ASPECT_SOURCE_DIR "/tests/data/real/rubik_03.b").value();
  const ClassIndex index = index_of(scene, options_of_level(1));
  REQUIRE(index.golden);
  CHECK(index.golden->regions >= 8);
  CHECK(self_test(index).outcome == Outcome::passed);
}

TEST_CASE("grey and surface indexes have golden frames, range indexes say that they have none") {
  for (const SensorKind sensor : {SensorKind::grey, SensorKind::surface, SensorKind::range}) {
    CompileOptions options = options_of_level(2);
    options.vision = default_parameters(sensor);
    const ClassIndex index = index_of(small_model_scene("blockcyl2"), options);
    INFO(name_of(sensor));
    CHECK(index.golden.has_value() == (sensor != SensorKind::range));
    const SelfTestResult result = self_test(index);
    INFO(result.line);
    CHECK(result.outcome == (sensor == SensorKind::range ? Outcome::absent : Outcome::passed));
    if (sensor == SensorKind::range) CHECK_THAT(result.line, Contains("has no golden frame"));
  }
}

}  // namespace aspect
