// PNM pictures as OpenCV writes them.
#include <algorithm>
#include <catch2/catch.hpp>

#include "runtime/capture/pnm_picture.h"
#include "tests/runtime/capture/sample_pictures.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

TEST_CASE("PPM pictures have the pixels that OpenCV wrote") {
  const TemporaryFolder folder;
  const cv::Mat picture = noise(33, 17);
  CapturedFrame frame;
  REQUIRE(read_pnm(folder.write("a.ppm", encoded(picture, ".ppm")), SensorKind::colour, frame));
  REQUIRE(frame.format == PixelFormat::rgb8);
  REQUIRE(frame.pixels.size() == std::size_t{33} * 17 * 3);
  for (std::size_t k = 0; k < frame.pixels.size(); ++k)
    REQUIRE(frame.pixels[k] == picture.data[k / 3 * 3 + 2 - k % 3]);
}

TEST_CASE("PGM pictures are grey frames, or colour frames without colours") {
  const TemporaryFolder folder;
  cv::Mat grey;
  cv::extractChannel(noise(9, 7), grey, 1);
  const auto file = folder.write("a.pgm", encoded(grey, ".pgm"));
  CapturedFrame frame;
  REQUIRE(read_pnm(file, SensorKind::grey, frame));
  CHECK(frame.format == PixelFormat::grey8);
  REQUIRE(frame.pixels.size() == 63);
  CHECK(std::equal(frame.pixels.begin(), frame.pixels.end(), grey.data));
  REQUIRE(read_pnm(file, SensorKind::colour, frame));
  REQUIRE(frame.pixels.size() == 189);
  for (std::size_t k = 0; k < 189; ++k) REQUIRE(frame.pixels[k] == grey.data[k / 3]);
}

}  // namespace
}  // namespace aspect
