#include "compiler/render/sensor.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <limits>

#include "tests/compiler/render/test_scenes.h"

namespace aspect {
namespace {

constexpr int kSide_px = 64;

Picture rendered_box() {
  const Scene scene = box_scene(kSide_px);
  Picture picture;
  renderer_of(scene).render(camera_at(scene.studio, Eigen::Vector3d(1, 2, 3).normalized()),
                            picture);
  return picture;
}

int number_of(const Frame& frame, int x, int y) {
  std::uint16_t number = 0;
  std::memcpy(&number, frame.data + y * frame.stride_bytes + 2 * x, sizeof number);
  return number;
}

VisionParameters parameters_of(SensorKind sensor) {
  return default_parameters(sensor);
}

}  // namespace

TEST_CASE("every sensor gives frames of its own format, of the picture's size") {
  const Picture picture = rendered_box();
  for (const SensorKind sensor :
       {SensorKind::colour, SensorKind::grey, SensorKind::range, SensorKind::surface}) {
    const auto eye = make_sensor(parameters_of(sensor));
    const Frame frame = eye->frame_of(picture);
    CHECK(gives(sensor, frame.format));
    CHECK(frame.width_px == kSide_px);
    CHECK(frame.height_px == kSide_px);
    CHECK(frame.stride_bytes == kSide_px * bytes_per_pixel(frame.format));
    for (const SensorKind other :
         {SensorKind::colour, SensorKind::grey, SensorKind::range, SensorKind::surface})
      CHECK(gives(other, frame.format) == (other == sensor));
  }
}

TEST_CASE("a colour frame is the picture, a grey one its brightness") {
  const Picture picture = rendered_box();
  const auto colour = make_sensor(parameters_of(SensorKind::colour));
  const auto grey = make_sensor(parameters_of(SensorKind::grey));
  CHECK(colour->frame_of(picture).data == picture.rgb.data());
  const Frame frame = grey->frame_of(picture);
  for (std::size_t i = 0; i < picture.surface.size(); ++i) {
    const double luma = 0.299 * picture.rgb[3 * i] + 0.587 * picture.rgb[3 * i + 1] +
                        0.114 * picture.rgb[3 * i + 2];
    REQUIRE(std::abs(frame.data[i] - luma) <= 1.0);
  }
}

TEST_CASE("a range frame holds depths in steps, and 0 where there are none") {
  Picture picture = rendered_box();
  picture.depth[0] = 1e-9F;
  picture.depth[1] = 1e9F;
  picture.depth[2] = std::numeric_limits<float>::quiet_NaN();
  picture.depth[3] = -1;
  VisionParameters parameters = parameters_of(SensorKind::range);
  parameters.range.step_length = 1.0F / 4096;
  const auto range = make_sensor(parameters);
  const Frame frame = range->frame_of(picture);
  int measured = 0;
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x) {
      const auto i = static_cast<std::size_t>(y * kSide_px + x);
      const int steps = number_of(frame, x, y);
      if (i < 4 || !std::isfinite(picture.depth[i])) {
        REQUIRE(steps == 0);
      } else {
        REQUIRE(std::abs(static_cast<float>(steps) / 4096 - picture.depth[i]) <= 0.5F / 4096);
        ++measured;
      }
    }
  CHECK(measured > 500);
}

TEST_CASE("a surface frame holds the ids of the primitives") {
  const Picture picture = rendered_box();
  const auto surface = make_sensor(parameters_of(SensorKind::surface));
  const Frame frame = surface->frame_of(picture);
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x)
      REQUIRE(number_of(frame, x, y) ==
              picture.surface[static_cast<std::size_t>(y * kSide_px + x)]);
}

}  // namespace aspect
