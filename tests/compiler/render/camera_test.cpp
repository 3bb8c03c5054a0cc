#include "compiler/render/camera.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/compiler/render/test_scenes.h"

using namespace aspect;
using Eigen::Vector3d;

namespace {

Eigen::Vector2d project(const Camera& camera, const Vector3d& point_object) {
  const Vector3d p = camera.camera_from_object * (point_object - camera.position_object);
  return {camera.intrinsics.cx_px + camera.intrinsics.fx_px * p.x() / p.z(),
          camera.intrinsics.cy_px + camera.intrinsics.fy_px * p.y() / p.z()};
}

}  // namespace

TEST_CASE("half the picture's width over the focal length is the tangent of half the angle") {
  Studio studio;
  studio.angle_deg = 50;
  const Intrinsics in = intrinsics_of(studio);
  CHECK(in.fx_px == Approx(548.993772).epsilon(1e-9));
  CHECK(in.fy_px == in.fx_px);
  CHECK(in.cx_px == 255.5);
  CHECK(in.cy_px == 255.5);
}

TEST_CASE("pixels are square in a wide picture, and stretched where the aspect says so") {
  Studio studio;
  studio.angle_deg = 90;
  studio.width_px = 640;
  studio.height_px = 480;
  studio.aspect = 640.0 / 480;
  CHECK(intrinsics_of(studio).fx_px == Approx(320));
  CHECK(intrinsics_of(studio).fy_px == Approx(320));
  studio.aspect = 1;
  CHECK(intrinsics_of(studio).fx_px == Approx(320));
  CHECK(intrinsics_of(studio).fy_px == Approx(240));
}

TEST_CASE("the camera on the z axis sees x to the right and y upwards") {
  Studio studio;
  studio.up = {0, 1, 0};
  studio.angle_deg = 90;
  const Camera camera = camera_at(studio, {0, 0, 1}, 2);
  CHECK(camera.position_object == Vector3d(0, 0, 2));
  CHECK(camera.camera_from_object.row(0).transpose() == Vector3d(1, 0, 0));
  CHECK(camera.camera_from_object.row(1).transpose() == Vector3d(0, -1, 0));
  CHECK(camera.camera_from_object.row(2).transpose() == Vector3d(0, 0, -1));
  CHECK(project(camera, {0, 0, 0}).isApprox(Eigen::Vector2d(255.5, 255.5)));
  CHECK(project(camera, {1, 0, 0}).isApprox(Eigen::Vector2d(255.5 + 128, 255.5)));
  CHECK(project(camera, {0, 1, 0}).isApprox(Eigen::Vector2d(255.5, 255.5 - 128)));
}

TEST_CASE("from any direction the camera is a rotation that looks at its target, upright") {
  Random random(1);
  Studio studio;
  studio.at = {0.1, -0.2, 0.3};
  for (int k = 0; k < 1000; ++k) {
    studio.up = 3 * random.direction();
    const Vector3d direction = random.direction();
    const double distance = random.uniform(0.5, 2);
    const Camera camera = camera_at(studio, direction, distance);
    const Eigen::Matrix3d& r = camera.camera_from_object;
    REQUIRE((r * r.transpose()).isIdentity(1e-12));
    REQUIRE(r.determinant() == Approx(1));
    const Vector3d target = r * (studio.at - camera.position_object);
    REQUIRE(target.isApprox(Vector3d(0, 0, distance), 1e-12));
    const Vector3d up_camera = r * studio.up;
    REQUIRE(std::abs(up_camera.x()) < 1e-9);
    REQUIRE(up_camera.y() < 0);
  }
}

TEST_CASE("looking along the up vector the camera is still a rotation, always the same one") {
  Studio studio;
  studio.up = {0, 0, 2};
  for (const double side : {-1.0, 1.0}) {
    const Camera camera = camera_at(studio, {0, 0, side});
    const Eigen::Matrix3d& r = camera.camera_from_object;
    CHECK((r * r.transpose()).isIdentity(1e-12));
    CHECK(r.determinant() == Approx(1));
    studio.up *= 7;
    CHECK(camera_at(studio, {0, 0, side}).camera_from_object == r);
    const Vector3d nearly = Vector3d(1e-12, -1e-12, side).normalized();
    CHECK(camera_at(studio, nearly).camera_from_object.isApprox(r, 1e-9));
  }
}
