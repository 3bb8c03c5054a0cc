// What is told of lower levels, against models compiled at these levels.
#include "compiler/aspects/level_coverage.h"

#include <catch2/catch.hpp>

#include "tests/tools/report/report_cube.h"

namespace aspect {

TEST_CASE("a model's lower levels are what a compilation at that level gives") {
  const Result<Renderer> renderer = Renderer::create(cube_scene());
  CompileOptions options = cube_options();
  options.min_level = 2;
  options.level = 4;
  options.border_views = 0;
  const auto compiled_at = [&](int level) {
    CompileOptions own = options;
    own.level = level;
    own.min_level = std::min(own.min_level, level);
    Result<Subdivision> found =
        subdivide({renderer.value(), cube_scene().studio, own, nullptr, {}, nullptr});
    REQUIRE(found.ok());
    return std::move(found).value();
  };
  Subdivision highest = compiled_at(4);
  const std::vector<LevelCoverage> levels = coverage_by_level(highest, options);
  REQUIRE(levels.size() == 3);
  for (const LevelCoverage& level : levels) {
    const Subdivision plain = compiled_at(level.level);
    const ClusterStatistics clusters = statistics_of(find_clusters(plain, options));
    CHECK(level.patches == plain.statistics.patches);
    CHECK(level.views == plain.statistics.views);
    CHECK(level.match_calls == plain.statistics.match_calls);
    CHECK(level.clusters == clusters.clusters);
    CHECK(level.area_fraction == clusters.area_fraction);
  }
  CHECK(levels[0].patches == 320);  // the thesis's Table 4.2
  CHECK(levels[0].views == 162);
  CHECK(levels[1].area_fraction < levels[2].area_fraction);
}

TEST_CASE("levels that the compiler passed over are told of as well") {
  const Result<Renderer> renderer = Renderer::create(cube_scene());
  CompileOptions options = cube_options();
  options.border_views = 0;
  Result<Subdivision> found =
      subdivide({renderer.value(), cube_scene().studio, options, nullptr, {}, nullptr});
  REQUIRE(found.ok());
  const std::vector<LevelCoverage> levels = coverage_by_level(found.value(), options);
  REQUIRE(levels.size() == 2);
  CHECK(levels[0].level == 2);
  CHECK(levels[0].patches == 320);
  CompileOptions low = options;
  low.level = low.min_level = 2;
  Result<Subdivision> plain =
      subdivide({renderer.value(), cube_scene().studio, low, nullptr, {}, nullptr});
  REQUIRE(plain.ok());
  CHECK(levels[0].match_calls == plain.value().statistics.match_calls);
  CHECK(levels[0].clusters == find_clusters(plain.value(), low).size());
}

}  // namespace aspect
