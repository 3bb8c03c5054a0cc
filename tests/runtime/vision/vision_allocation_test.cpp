#include <catch2/catch.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "tests/rounds.h"
#include "tests/runtime/base/allocation_counter.h"
#include "tests/runtime/vision/pictures.h"

namespace aspect {
namespace {

std::vector<cv::Mat> varied_frames() {
  std::mt19937 random(39);
  std::vector<cv::Mat> frames = {cv::Mat::zeros(96, 128, CV_8UC3),
                                 cv::Mat(96, 128, CV_8UC3, cv::Scalar(255, 255, 255))};
  for (int i = 0; i < 20; ++i) {
    const cv::Size size{20 + static_cast<int>(random() % 109),
                        20 + static_cast<int>(random() % 77)};
    frames.push_back(polygon_picture(random, size, 3 + i % 8));
    frames.push_back(noise_picture(random, size));
    cv::Mat soft;
    cv::GaussianBlur(frames.back(), soft, {}, 1.0 + i % 4);
    frames.push_back(soft);
  }
  // More contours than a blob may have: what is rare must not allocate either.
  cv::Mat crowded = cv::Mat::zeros(96, 128, CV_8UC3);
  for (int i = 0; i < 96; ++i) crowded(cv::Rect(i % 12 * 10, i / 12 * 11, 8, 8)) = colour(i);
  frames.push_back(crowded);
  return frames;
}

}  // namespace

TEST_CASE("a thousand frames of all kinds take no memory from the heap") {
  const std::vector<cv::Mat> frames = varied_frames();
  OwnedVision vision(128, 96);
  std::size_t contours = 0, crowded = 0;
  const std::uint64_t before = allocation_count();
  for (std::size_t i = 0; i < 1000; ++i) {
    VisionParameters parameters;
    parameters.smooth = i % 3 != 0;
    parameters.one_blob = i % 5 == 0;
    parameters.relations_max = static_cast<int>(i % 4) * 10;
    const ViewGraph graph = vision.run(frames[i % frames.size()], parameters);
    contours += graph.contours.size();
    crowded += graph.dropped_regions > 0 ? 1 : 0;
  }
  REQUIRE(allocation_count() - before == 0);
  REQUIRE(contours > 1000);
  REQUIRE(crowded > 0);
}

TEST_CASE("frames of other sensors take no memory from the heap either") {
  std::mt19937 random(40);
  std::vector<std::uint8_t> bytes(2 * 128 * 96);
  for (const SensorKind sensor : {SensorKind::grey, SensorKind::range, SensorKind::surface}) {
    OwnedVision vision(128, 96, sensor);
    const PixelFormat format = sensor == SensorKind::grey    ? PixelFormat::grey8
                               : sensor == SensorKind::range ? PixelFormat::depth16
                                                             : PixelFormat::label16;
    std::size_t contours = 0;
    const std::uint64_t before = allocation_count();
    for (int i = 0; i < rounds(100); ++i) {
      // Fields of 16 rows and 32 bytes, and noise in every fifth frame.
      for (std::size_t k = 0; k < bytes.size(); ++k) {
        const bool starts_field = k % 32 == 0 && k / 256 % 16 == 0;
        bytes[k] = starts_field || i % 5 == 0 ? static_cast<std::uint8_t>(random())
                   : k % 32 != 0              ? bytes[k - 1]
                                              : bytes[k - 256];
      }
      const Frame frame{bytes.data(), 128, 96, 128 * bytes_per_pixel(format), format};
      VisionParameters parameters = default_parameters(sensor);
      parameters.area_min_px = 1;
      parameters.thickness_min_px = 0;
      contours += vision.run(frame, parameters).contours.size();
    }
    REQUIRE(allocation_count() - before == 0);
    REQUIRE(contours > 0);
  }
}

TEST_CASE("the counter that says so counts in this program") {
  const std::uint64_t before = allocation_count();
  const std::vector<cv::Mat> frames = varied_frames();
  REQUIRE(allocation_count() > before);
}

}  // namespace aspect
