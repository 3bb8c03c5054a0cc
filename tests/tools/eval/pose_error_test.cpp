#include "tools/eval/pose_error.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tools/eval/random_directions.h"

namespace aspect {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
const Vector3d kX{1, 0, 0}, kZ{0, 0, 1};
const RigidPose kAhead{{}, {0, 0, 10}};

// Two points at 1 from the centre; nothing but the model and the symmetries is used.
ClassIndex two_points(const Vector3d& centre = {}) {
  ClassIndex index;
  index.model.centre = centre;
  index.model.vertices = {centre + kX, centre - kX};
  return index;
}

Intrinsics hundred_px() {
  Intrinsics camera;
  camera.width_px = 30;
  camera.height_px = 40;
  camera.fx_px = camera.fy_px = 100;
  return camera;
}

PoseError error_of(const ClassIndex& index, const RigidPose& found) {
  return pose_error(index, hundred_px(), kAhead, found);
}

RigidPose turned(const Vector3d& axis, double angle_deg) {
  return {turn_about(axis, angle_deg * kDegree), kAhead.translation};
}

void check_none(const PoseError& error) {
  CHECK(error.rotation_deg < 1e-4);
  CHECK(error.translation_percent < 1e-6);
  CHECK(error.reprojection_px < 1e-4);
}

}  // namespace

TEST_CASE("A camera on the x axis with z up sees y to the right and z upwards") {
  Studio studio;
  studio.at = {0, 0, 5};
  studio.distance = 2;
  const RigidPose pose = true_pose(camera_at(studio, Eigen::Vector3d::UnitX()));
  const auto check_at = [&](const Vector3d& point, const Vector3d& expected) {
    CHECK(norm(pose(point) - expected) < 1e-12);
  };
  check_at({0, 0, 5}, {0, 0, 2});
  check_at({0, 1, 5}, {1, 0, 2});
  check_at({0, 0, 6}, {0, -1, 2});
  check_at({1, 0, 5}, {0, 0, 1});
}

TEST_CASE("True poses are turned as the recogniser's cameras without roll, ahead by the distance") {
  Studio studio;
  studio.at = {0.1, -0.2, 0.3};
  studio.up = {0, 1, 0};
  studio.distance = 3;
  for (const Eigen::Vector3d& d : random_directions(50, 2)) {
    const RigidPose pose = true_pose(camera_at(studio, d));
    const Rotation right = camera_from_object({d.x(), d.y(), d.z()}, {0, 1, 0});
    CHECK(angle_between_rad(pose.rotation, right) < 1e-6);
    CHECK(norm(pose({0.1, -0.2, 0.3}) - Vector3d{0, 0, 3}) < 1e-12);
  }
}

TEST_CASE("The true pose has no error") {
  check_none(error_of(two_points(), kAhead));
}

TEST_CASE(
    "Half a unit to the side at ten is 5 % of the distance, and 5 px at 100 px focal length") {
  const PoseError error = error_of(two_points(), {{}, {0.5, 0, 10}});
  CHECK(error.rotation_deg < 1e-4);
  CHECK(error.translation_percent == Approx(5));
  CHECK(error.reprojection_px == Approx(5));
}

TEST_CASE("Pixels are root mean squares over the vertices") {
  ClassIndex index = two_points();
  // On the axis of the turn: 0 px off; the others move from 10 px along x to 10 px along y.
  index.model.vertices = {kX, -1 * kX, {}, {}};
  const PoseError error = error_of(index, turned(kZ, 90));
  CHECK(error.rotation_deg == Approx(90));
  CHECK(error.translation_percent < 1e-9);
  CHECK(error.reprojection_px == Approx(std::sqrt((200.0 + 200) / 4)));
}

TEST_CASE("What an object's half turn hides is no error, what is beyond it is") {
  ClassIndex index = two_points();
  CHECK(error_of(index, turned(kZ, 180)).rotation_deg == Approx(180));
  index.symmetries = {{0, 0, 0, 1}};
  check_none(error_of(index, turned(kZ, 180)));
  const PoseError error = error_of(index, turned(kZ, 170));
  CHECK(error.rotation_deg == Approx(10));
  CHECK(error.reprojection_px == Approx(2 * 10 * std::sin(5 * kDegree)));
}

TEST_CASE("Symmetries turn about the object's centre, wherever it is") {
  ClassIndex index = two_points(kX);
  index.symmetries = {{0, 0, 0, 1}};
  check_none(error_of(index, {turn_about(kZ, std::numbers::pi), {2, 0, 10}}));
  // About the origin it takes the centre from 1 to -1.
  const PoseError error = error_of(index, turned(kZ, 180));
  CHECK(error.rotation_deg < 1e-4);
  CHECK(error.translation_percent == Approx(100 * 2 / std::sqrt(101.0)));
  CHECK(error.reprojection_px == Approx(20));
}

TEST_CASE("A turn about a round axis is no error by any angle, a tilt of the axis is") {
  ClassIndex index = two_points();
  index.symmetry_axes = {{0, 0, 1}};
  for (const double angle_deg : {0.3, 33.3, 179.9, -120.0}) {
    check_none(error_of(index, turned(kZ, angle_deg)));
    const RigidPose tilted{turn_about(kX, 4 * kDegree) * turn_about(kZ, angle_deg * kDegree),
                           kAhead.translation};
    CHECK(error_of(index, tilted).rotation_deg == Approx(4));
  }
  CHECK(error_of(index, turned(kX, 176)).rotation_deg == Approx(176));
  index.symmetries = {{0, 1, 0, 0}};
  CHECK(error_of(index, turned(kX, 176)).rotation_deg == Approx(4));
}

TEST_CASE("The error modulo a round axis is the least over small steps of the turn") {
  ClassIndex index = two_points();
  const float third = 1 / std::sqrt(3.0F);
  index.symmetry_axes = {{third, third, third}};
  const double wide = 1 / std::sqrt(3.0);
  const auto directions = random_directions(40, 3);
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const Eigen::Vector3d& d = directions[k];
    const RigidPose found = turned({d.x(), d.y(), d.z()}, 4.5 * static_cast<double>(k));
    double least = 360;
    for (int step = 0; step < 7200; ++step)
      least = std::min(least, angle_between_rad(turn_about({wide, wide, wide}, step * kDegree / 20),
                                                found.rotation));
    CHECK(error_of(index, found).rotation_deg == Approx(least / kDegree).margin(0.03));
    CHECK(error_of(index, found).rotation_deg <= least / kDegree + 1e-4);
  }
}

TEST_CASE("No turn of a ball is an error") {
  ClassIndex index = two_points();
  index.symmetry_axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  check_none(error_of(index, turned({0.6, 0, 0.8}, 77)));
  CHECK(error_of(index, {turn_about(kX, 1), {0, 0, 9}}).translation_percent == Approx(10));
}

TEST_CASE("What is behind the camera is off by the picture's diagonal, and nothing by more") {
  CHECK(error_of(two_points(), {{}, {0, 0, -10}}).reprojection_px == Approx(50));
  CHECK(error_of(two_points(), {{}, {1000, 0, 10}}).reprojection_px == Approx(50));
}

}  // namespace aspect
