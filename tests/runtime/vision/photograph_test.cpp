// What a camera and its JPEG files do to pictures. Apart from the other tests of vision, which are
// run on devices' processors, too: the codecs' packages are too large to be fetched for that.
#include <algorithm>
#include <catch2/catch.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "tests/runtime/vision/pictures.h"

namespace aspect {
namespace {

cv::Mat photographed(const cv::Mat& picture, unsigned seed) {
  cv::Mat noise(picture.size(), CV_16SC3), sum;
  cv::RNG random(seed);
  random.fill(noise, cv::RNG::NORMAL, 0, 3);
  cv::add(blurred(picture), noise, sum, cv::noArray(), CV_8U);
  std::vector<std::uint8_t> jpeg;
  // OpenCV writes blue first; which channel is which matters to the codec's colour planes.
  cv::cvtColor(sum, sum, cv::COLOR_RGB2BGR);
  cv::imencode(".jpg", sum, jpeg, {cv::IMWRITE_JPEG_QUALITY, 90});
  cv::Mat out = cv::imdecode(jpeg, cv::IMREAD_COLOR);
  cv::cvtColor(out, out, cv::COLOR_BGR2RGB);
  return out;
}

}  // namespace

TEST_CASE("blur, noise and JPEG leave the number of regions and their areas within 3 %") {
  std::mt19937 random(13);
  VisionParameters parameters = exact_parameters();
  parameters.smooth = true;
  // Half the sum of the darkest colour: blur against black takes as much as it gives.
  parameters.intensity_min = 140;
  for (unsigned round = 0; round < 25; ++round) {
    const cv::Mat picture = surface_picture(random, {400, 400});
    const std::vector<double> expected = areas_of(picture, parameters);
    REQUIRE(expected.size() >= 3);
    for (const cv::Mat& worse : {blurred(picture), photographed(picture, round)}) {
      const std::vector<double> areas = areas_of(worse, parameters);
      REQUIRE(areas.size() == expected.size());
      for (std::size_t k = 0; k < areas.size(); ++k)
        REQUIRE(areas[k] == Approx(expected[k]).epsilon(0.03));
    }
  }
}

}  // namespace aspect
