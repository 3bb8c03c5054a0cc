#include "tools/score/known_rotations.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace aspect {
namespace {

using Catch::Matchers::StartsWith;

const Eigen::Vector3d kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

TEST_CASE("Errors are measured modulo the listed turns of the object alone") {
  const auto rotations =
      KnownRotations::parse_csv("object,x,y,z,degrees\nblock,0,2,0,180\n", "s.csv");
  REQUIRE(rotations.ok());
  CHECK(rotations.value().view_error_deg("block", kX, -kX) == Approx(0).margin(1e-6));
  CHECK(rotations.value().view_error_deg("block", kX, kZ) == Approx(90));
  CHECK(rotations.value().view_error_deg("block", kY, -kY) == Approx(180));
  CHECK(rotations.value().view_error_deg("other", kX, -kX) == Approx(180));
  CHECK(KnownRotations().view_error_deg("block", kX, kY) == Approx(90));
}

TEST_CASE("Without degrees any angle is meant") {
  const auto rotations = KnownRotations::parse_csv("wheel,0,0,1,\n", "s.csv");
  REQUIRE(rotations.ok());
  const double angle = 2.345;
  const Eigen::Vector3d turned(std::cos(angle), std::sin(angle), 0);
  CHECK(rotations.value().view_error_deg("wheel", kX, turned) < 0.5);
  CHECK(rotations.value().view_error_deg("wheel", kX, kZ) == Approx(90));
}

TEST_CASE("TOML says the same as CSV") {
  const auto rotations = KnownRotations::parse_toml(
      "[[symmetry]]\nobject = \"block\"\naxis = [0, 1.0, 0]\ndegrees = 180\n"
      "[[symmetry]]\nobject = \"wheel\"\naxis = [0, 0, 1]\n",
      "s.toml");
  REQUIRE(rotations.ok());
  CHECK(rotations.value().view_error_deg("block", kX, -kX) == Approx(0).margin(1e-6));
  CHECK(rotations.value().view_error_deg("wheel", kX, kY) == Approx(0).margin(1e-5));
}

TEST_CASE("Symmetries that make no sense are told with their line") {
  for (const char* row : {"block,0,1,0", "block,0,0,0,90", "block,0,1,x,90", "block,0,1,0,x",
                          "block,0,inf,0,90", "block"}) {
    INFO(row);
    const auto rotations = KnownRotations::parse_csv("block,0,1,0,90\n" + std::string(row), "s");
    REQUIRE_FALSE(rotations.ok());
    CHECK_THAT(rotations.error(), StartsWith("s:2: "));
  }
  for (const char* text :
       {"\n[symmetry]\nobject = 3\n", "\n[[symmetry]]\nobject = 'a'\naxis = [0, 1]\n",
        "\n[[symmetry]]\nobject = 'a'\naxis = [0, 0, 0]\n", "\nsymmetry = 3\n",
        "\n[[symmetry]]\nobject = 'a'\naxis = [0, 1, 0]\ndegrees = 'x'\n", "\n[[symmetri]]\n",
        "\n[[symmetry\n"}) {
    INFO(text);
    const auto rotations = KnownRotations::parse_toml(text, "s");
    REQUIRE_FALSE(rotations.ok());
    CHECK_THAT(rotations.error(), StartsWith("s:2: "));
  }
}

}  // namespace
}  // namespace aspect
