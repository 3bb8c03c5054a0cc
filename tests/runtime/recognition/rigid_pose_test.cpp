#include "runtime/recognition/rigid_pose.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numbers>
#include <random>

namespace aspect {
namespace {

constexpr int kRounds = 200;

Eigen::Vector3d eigen(const Vector3d& v) {
  return {v[0], v[1], v[2]};
}

Eigen::Quaterniond eigen(const Rotation& r) {
  return {r.w, r.x, r.y, r.z};
}

Vector3d random_unit(std::mt19937& random) {
  std::normal_distribution<double> number;
  const Vector3d v{number(random), number(random), number(random)};
  return (1 / norm(v)) * v;
}

Rotation random_rotation(std::mt19937& random) {
  return turn_about(random_unit(random), std::uniform_real_distribution<double>(
                                             -std::numbers::pi, std::numbers::pi)(random));
}

}  // namespace

TEST_CASE("Rotations turn, follow one another and turn back as Eigen's do") {
  std::mt19937 random(1);
  for (int round = 0; round < kRounds; ++round) {
    const Rotation a = random_rotation(random), b = random_rotation(random);
    const Vector3d p = random_unit(random);
    CHECK((eigen(a(p)) - eigen(a) * eigen(p)).norm() < 1e-12);
    CHECK((eigen((a * b)(p)) - eigen(a) * (eigen(b) * eigen(p))).norm() < 1e-12);
    CHECK((eigen(inverse(a)(a(p))) - eigen(p)).norm() < 1e-12);
    CHECK(angle_between_rad(a, b) == Approx(eigen(a).angularDistance(eigen(b))).margin(1e-7));
    CHECK(angle_between_rad(a, rotation_from_rows(a.rows())) < 1e-7);
  }
}

TEST_CASE("A turn between two directions is the least one that takes the first to the second") {
  std::mt19937 random(2);
  for (int round = 0; round < kRounds; ++round) {
    const Vector3d from = random_unit(random), to = random_unit(random);
    const Rotation turn = turn_between(from, to);
    CHECK(norm(turn(from) - to) < 1e-12);
    CHECK(angle_between_rad({}, turn) == Approx(std::acos(dot(from, to))).margin(1e-6));
  }
  const Vector3d x{1, 0, 0};
  CHECK(norm(turn_between(x, {-1, 0, 0})(x) - Vector3d{-1, 0, 0}) < 1e-12);
}

TEST_CASE("A camera that looks at the object from a direction has it ahead and up above") {
  std::mt19937 random(3);
  const Vector3d up{0, 0, 1};
  for (int round = 0; round < kRounds; ++round) {
    const Vector3d direction = random_unit(random);
    const Rotation camera = camera_from_object(direction, up);
    CHECK(norm(camera(direction) - Vector3d{0, 0, -1}) < 1e-9);
    const Vector3d seen_up = camera(up);
    CHECK(std::abs(seen_up[0]) < 1e-9);
    CHECK(seen_up[1] <= 1e-9);  // y is down
  }
  CHECK(std::isfinite(camera_from_object(up, up).w));
}

}  // namespace aspect
