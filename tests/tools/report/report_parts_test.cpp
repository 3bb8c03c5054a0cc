#include <catch2/catch.hpp>
#include <random>

#include "tests/compiler/aspects/symmetric_scenes.h"
#include "tools/report/aspect_views.h"
#include "tools/report/object_axes.h"
#include "tools/report/svg_figure.h"
#include "tools/report/thesis_rows.h"

namespace aspect {

TEST_CASE("the rotations of a cube are those about its 13 axes") {
  Symmetries symmetries;
  symmetries.rotations = colour_rotations({0, 0, 0, 0, 0, 0});
  REQUIRE(symmetries.rotations.size() == 23);
  std::map<int, int> axes;
  for (const ObjectAxis& axis : object_axes(symmetries)) {
    ++axes[axis.fold];
    CHECK(axis.direction.norm() == Approx(1));
  }
  CHECK(axes == std::map<int, int>{{4, 3}, {3, 4}, {2, 6}});
}

TEST_CASE("a round axis comes first, and has no fold") {
  Symmetries symmetries;
  symmetries.axes = {{0, 0, -1}};
  symmetries.rotations = {
      Eigen::Quaterniond(Eigen::AngleAxisd(3.14159265358979, Eigen::Vector3d::UnitX()))};
  const std::vector<ObjectAxis> axes = object_axes(symmetries);
  REQUIRE(axes.size() == 2);
  CHECK(axes[0].fold == 0);
  CHECK(axes[0].direction == Eigen::Vector3d(0, 0, 1));
  CHECK(axes[1].fold == 2);
}

TEST_CASE("the thesis's rows are found by the object's name") {
  const std::vector<ThesisRow> cube = thesis_rows("cube");
  REQUIRE(cube.size() == 7);
  CHECK(cube.back().level == 7);
  CHECK(cube.back().cluster_threshold == 100000);
  CHECK(cube.back().clusters == 26);
  CHECK(cube.back().area_fraction == 0.972113);
  CHECK(thesis_rows("TRUCK").size() == 21);
  CHECK(thesis_rows("truck_unique").empty());
  CHECK(thesis_rows("").empty());
}

TEST_CASE("a name may be anything without doing harm") {
  CHECK(escaped("a<b>&\"c\"") == "a&lt;b&gt;&amp;&quot;c&quot;");
  CHECK(escaped("Schr\u00e4ubchen \u2265 \U0001F600") == "Schr\u00e4ubchen \u2265 \U0001F600");
  CHECK(escaped("a\nb\x01") == "a?b?");
  CHECK(escaped("\xff\xc0\x80") == "???");     // no UTF-8, and a NUL in disguise
  CHECK(escaped("\xed\xa0\x80") == "???");     // a surrogate
  CHECK(escaped("end \xe2\x82") == "end ??");  // cut short
}

TEST_CASE("base64 is RFC 4648's") {
  const auto coded = [](std::string_view text) {
    return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  };
  CHECK(coded("") == "");
  CHECK(coded("f") == "Zg==");
  CHECK(coded("fo") == "Zm8=");
  CHECK(coded("foo") == "Zm9v");
  CHECK(coded("foobar") == "Zm9vYmFy");
}

TEST_CASE("an outline with fewer points stays near all that it had") {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> step(-1, 1);
  PixelLine line;
  for (int k = 0; k < 200; ++k) {
    const double angle = 0.0314159 * k;
    line.push_back({static_cast<int>(90 * std::cos(angle)) + step(random),
                    static_cast<int>(60 * std::sin(angle)) + step(random)});
  }
  const PixelLine fewer = simplified(line, 2);
  CHECK(fewer.size() < line.size() / 3);
  const auto point = [](const std::array<int, 2>& p) { return Eigen::Vector2d(p[0], p[1]); };
  for (const auto& p : line) {
    double least = 1e9;
    for (std::size_t k = 0; k < fewer.size(); ++k) {
      const Eigen::Vector2d a = point(fewer[k]);
      const Eigen::Vector2d way = point(fewer[(k + 1) % fewer.size()]) - a, to = point(p) - a;
      const double share = std::clamp(to.dot(way) / way.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (to - share * way).norm());
    }
    // Beyond the ends of a line its distance is not that from the piece between them.
    CHECK(least <= 3);
  }
}

}  // namespace aspect
