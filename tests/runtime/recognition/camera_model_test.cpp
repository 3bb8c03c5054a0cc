#include "runtime/recognition/camera_model.h"

#include <catch2/catch.hpp>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <random>

namespace aspect {
namespace {

constexpr int kWidth_px = 640, kHeight_px = 480;

CameraModel random_camera(std::mt19937& random) {
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (;;) {
    const CameraModel camera{number(400, 900),    number(400, 900),    number(200, 440),
                             number(150, 330),    number(-0.4, 0.3),   number(-0.1, 0.2),
                             number(-0.01, 0.01), number(-0.01, 0.01), number(-0.05, 0.05)};
    if (is_sound(camera, kWidth_px, kHeight_px)) return camera;
  }
}

Point2d projected_by_opencv(const CameraModel& camera, const cv::Point3d& p) {
  const cv::Matx33d matrix(camera.fx_px, 0, camera.cx_px, 0, camera.fy_px, camera.cy_px, 0, 0, 1);
  const cv::Matx<double, 1, 5> bends(camera.k1, camera.k2, camera.p1, camera.p2, camera.k3);
  std::vector<cv::Point2d> seen;
  cv::projectPoints(std::vector<cv::Point3d>{p}, cv::Vec3d(), cv::Vec3d(), matrix, bends, seen);
  return {seen[0].x, seen[0].y};
}

}  // namespace

TEST_CASE("A lens bends points as OpenCV's model says, and they are straightened again") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> across(0, kWidth_px - 1), down(0, kHeight_px - 1);
  for (int round = 0; round < 300; ++round) {
    const CameraModel camera = random_camera(random);
    const Point2d straight{across(random), down(random)};
    const Point2d bent = camera.bent(straight);
    const Point2d expected =
        projected_by_opencv(camera, {(straight.x - camera.cx_px) / camera.fx_px,
                                     (straight.y - camera.cy_px) / camera.fy_px, 1});
    CHECK(bent.x == Approx(expected.x).margin(1e-6));
    CHECK(bent.y == Approx(expected.y).margin(1e-6));
    const Point2d back = camera.straight(bent);
    CHECK(back.x == Approx(straight.x).margin(1e-3));
    CHECK(back.y == Approx(straight.y).margin(1e-3));
  }
}

TEST_CASE("A lens is refused that folds the picture or is no lens") {
  const CameraModel sound{500, 500, 320, 240, 0, 0, 0, 0, 0};
  CHECK(is_sound(sound, kWidth_px, kHeight_px));
  const auto with = [&](auto change) {
    CameraModel camera = sound;
    change(camera);
    return is_sound(camera, kWidth_px, kHeight_px);
  };
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(with([](CameraModel& c) { c.fx_px = 0; }));
  CHECK_FALSE(with([](CameraModel& c) { c.fy_px = -500; }));
  CHECK_FALSE(with([](CameraModel& c) { c.fx_px = kNaN; }));
  CHECK_FALSE(with([](CameraModel& c) { c.cx_px = kNaN; }));
  CHECK_FALSE(with([](CameraModel& c) { c.k2 = std::numeric_limits<double>::infinity(); }));
  CHECK_FALSE(with([](CameraModel& c) { c.k1 = -1; }));  // the corner comes back inside
  CHECK_FALSE(with([](CameraModel& c) { c.p1 = 2; }));
  CHECK(with([](CameraModel& c) { c.k1 = -0.3; }));
}

}  // namespace aspect
