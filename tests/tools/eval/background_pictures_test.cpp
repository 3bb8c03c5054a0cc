#include "tools/eval/background_pictures.h"

#include <catch2/catch.hpp>
#include <string>

#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

std::string ppm(int width, int height, const std::string& rgb) {
  std::string bytes = "P6\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
  for (int k = 0; k < width * height; ++k) bytes += rgb;
  return bytes;
}

std::string error_of(const std::filesystem::path& folder) {
  const auto pictures = read_backgrounds(folder, 100);
  REQUIRE_FALSE(pictures.ok());
  CHECK(pictures.error().find('\n') == std::string::npos);
  return pictures.error();
}

}  // namespace

TEST_CASE("Backgrounds come in the order of their names, red first, and no larger than asked") {
  const TemporaryFolder folder;
  folder.write("b.ppm", ppm(40, 20, {10, 20, 30}));
  folder.write("a.ppm", ppm(8, 400, {1, 2, 3}));
  folder.write("notes.txt", "no picture");
  const auto pictures = read_backgrounds(folder.path(), 100);
  REQUIRE(pictures.ok());
  CHECK(pictures.value().found == 2);
  REQUIRE(pictures.value().rgb.size() == 2);
  const cv::Mat &a = pictures.value().rgb[0], &b = pictures.value().rgb[1];
  CHECK(a.size() == cv::Size(2, 100));
  CHECK(a.at<cv::Vec3b>(50, 1) == cv::Vec3b(1, 2, 3));
  CHECK(b.size() == cv::Size(40, 20));
  CHECK(b.at<cv::Vec3b>(0, 0) == cv::Vec3b(10, 20, 30));
}

TEST_CASE("Of very many pictures those at even steps are read") {
  const TemporaryFolder folder;
  for (int k = 0; k < 400; ++k)
    folder.write(std::to_string(1000 + k) + ".ppm", ppm(4, 4, std::string(3, char(k % 100))));
  const auto pictures = read_backgrounds(folder.path(), 100);
  REQUIRE(pictures.ok());
  CHECK(pictures.value().found == 400);
  REQUIRE(pictures.value().rgb.size() == kMostBackgrounds);
  for (int k = 0; k < 200; ++k)
    CHECK(pictures.value().rgb[static_cast<std::size_t>(k)].at<cv::Vec3b>(0, 0)[0] == 2 * k % 100);
}

TEST_CASE("A folder that is no good is told in one line") {
  const TemporaryFolder folder;
  CHECK_THAT(error_of(folder / "none"), EndsWith("none: no such folder; check the path"));
  CHECK_THAT(error_of(folder.path()), StartsWith(folder.path().native() + ": holds no pictures"));
  const auto file = folder.write("good.ppm", ppm(4, 4, "abc"));
  CHECK_THAT(error_of(file), StartsWith(file.native() + ": not a folder"));
  const auto bad = folder.write("bad.png", "no picture");
  CHECK_THAT(error_of(folder.path()), StartsWith(bad.native() + ": not a picture"));
}

}  // namespace aspect
