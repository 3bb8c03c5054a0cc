// OpenCV traces the same kind of border: foreground 8-connected, holes 4-connected. Our regions are
// 4-connected, so a region's mask is one piece to OpenCV as well, even where it touches itself
// corner to corner; both then take such a corner as closed and count what it cuts off as a hole.
// Masks of single regions can therefore be compared as they are, border by border.
#include "runtime/vision/contour_trace.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "tests/rounds.h"
#include "tests/runtime/vision/pictures.h"

namespace aspect {
namespace {

using PixelSet = std::set<std::pair<int, int>>;

// A map of labels drawn by the test, as if the segmentation had found them.
struct DrawnMap {
  std::vector<std::uint16_t> labels;
  std::vector<Run> runs;
  std::vector<std::uint8_t> chains;
  RegionMap map;
  OwnedArena memory;
  ContourTracer tracer;

  explicit DrawnMap(const cv::Mat& picture) : memory(tracer_bytes(picture.size())) {
    const int width = picture.cols, height = picture.rows;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        labels.push_back(static_cast<std::uint16_t>(picture.at<int>(y, x)));
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width;) {
        const int label = picture.at<int>(y, x), begin = x;
        while (x < width && picture.at<int>(y, x) == label) ++x;
        if (label != 0)
          runs.push_back({static_cast<std::uint16_t>(y), static_cast<std::uint16_t>(begin),
                          static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(label)});
      }
    map = {labels, width, {0, 0, width, height}, runs, {}, {}, 0, {}};
    Arena arena = memory.arena();
    tracer.take(arena, width, height);
    chains.resize(labels.size() / 2 + 1024);
    tracer.lend(chains);
  }

  static std::size_t tracer_bytes(cv::Size size) {
    Arena counting;
    ContourTracer().take(counting, size.width, size.height);
    return counting.used_bytes();
  }
};

// The pixels of a chain; checks that it ends where it started.
PixelSet pixels_of(const TracedContour& contour) {
  PixelSet pixels;
  int x = contour.start_x, y = contour.start_y;
  pixels.emplace(x, y);
  for (const std::uint8_t code : contour.chain) {
    REQUIRE(code < 8);
    x += kStepX[code];
    y += kStepY[code];
    pixels.emplace(x, y);
  }
  REQUIRE(x == contour.start_x);
  REQUIRE(y == contour.start_y);
  return pixels;
}

struct Borders {
  PixelSet external;
  std::multiset<PixelSet> internal;
  friend bool operator==(const Borders&, const Borders&) = default;
};

Borders opencv_borders(const cv::Mat& mask) {
  std::vector<std::vector<cv::Point>> contours;
  std::vector<cv::Vec4i> hierarchy;
  cv::findContours(mask, contours, hierarchy, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  Borders borders;
  for (std::size_t k = 0; k < contours.size(); ++k) {
    PixelSet pixels;
    for (const cv::Point& point : contours[k]) pixels.emplace(point.x, point.y);
    if (hierarchy[k][3] >= 0)
      borders.internal.insert(std::move(pixels));
    else
      borders.external.insert(pixels.begin(), pixels.end());
  }
  return borders;
}

cv::Point first_pixel(const cv::Mat& mask) {
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x)
      if (mask.at<std::uint8_t>(y, x) != 0) return {x, y};
  return {-1, -1};
}

// External borders start at the region's first pixel, internal ones west of the hole's.
void check_start(const cv::Mat& mask, const TracedContour& contour) {
  const cv::Point start(contour.start_x, contour.start_y);
  if (contour.external) {
    REQUIRE(start == first_pixel(mask));
    return;
  }
  cv::Mat outside;
  cv::connectedComponents(255 - mask, outside, 4, CV_32S);
  const int hole = outside.at<int>(start.y, start.x + 1);
  REQUIRE(hole != 0);
  REQUIRE(start + cv::Point(1, 0) == first_pixel(mask_of(outside, hole)));
}

void check_against_opencv(const cv::Mat& labels) {
  DrawnMap drawn(labels);
  int dropped = 0;
  const auto traced = drawn.tracer.run(drawn.map, 0, dropped);
  REQUIRE(dropped == 0);
  double count = 0;
  cv::minMaxLoc(labels, nullptr, &count);
  std::size_t met = 0;
  for (int label = 1; label <= static_cast<int>(count); ++label) {
    const cv::Mat mask = mask_of(labels, label);
    Borders found;
    for (const TracedContour& contour : traced) {
      if (contour.label != label) continue;
      ++met;
      check_start(mask, contour);
      if (contour.external)
        found.external = pixels_of(contour);
      else
        found.internal.insert(pixels_of(contour));
    }
    REQUIRE(found == opencv_borders(mask));
  }
  REQUIRE(met == traced.size());
}

cv::Mat labels_of_text(const std::vector<std::string>& rows) {
  cv::Mat picture(static_cast<int>(rows.size()), static_cast<int>(rows[0].size()), CV_8U);
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x) {
      const char letter = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      picture.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(letter == '.' ? 0 : letter);
    }
  return equal_components(picture);
}

}  // namespace

TEST_CASE("borders of random regions are OpenCV's, external and internal") {
  std::mt19937 random(18);
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 9), cv::Size(9, 1), cv::Size(3, 3),
                              cv::Size(15, 11), cv::Size(32, 32), cv::Size(40, 23)})
    for (const double density : {0.1, 0.4, 0.55, 0.65, 0.8, 0.9, 1.0})
      for (int round = 0; round < 8; ++round)
        check_against_opencv(equal_components(random_mask(random, size, density)));
}

TEST_CASE("borders of regions that touch each other are OpenCV's") {
  std::mt19937 random(19);
  for (int round = 0; round < rounds(60); ++round) {
    cv::Mat picture = noise_picture(random, {40, 30});
    cv::GaussianBlur(picture, picture, {}, 1 + round % 3);
    cv::Mat first;
    cv::extractChannel(picture, first, 0);
    // A few grey levels: nested and touching regions without background between them.
    for (int y = 0; y < first.rows; ++y)
      for (int x = 0; x < first.cols; ++x) {
        auto& value = first.at<std::uint8_t>(y, x);
        value = static_cast<std::uint8_t>(1 + value / 12);
      }
    check_against_opencv(equal_components(first));
  }
}

TEST_CASE("a region that touches itself at a corner closes a hole there") {
  check_against_opencv(labels_of_text({"aaaa", "a..a", "a.a.", "aaa."}));
  check_against_opencv(labels_of_text({".a.", "aaa", ".a."}));
  check_against_opencv(labels_of_text({"aaaaaaa", "a.a.a.a", "aa.a.aa", "a.a.a.a", "aaaaaaa"}));
}

TEST_CASE("small holes are left out") {
  const cv::Mat labels = labels_of_text(
      {"aaaaaaaaaaaa", "a.aa......aa", "aaaa......aa", "aaaa......aa", "aaaaaaaaaaaa"});
  DrawnMap drawn(labels);
  int dropped = 0;
  REQUIRE(drawn.tracer.run(drawn.map, 0, dropped).size() == 3);
  const auto larger = drawn.tracer.run(drawn.map, 3, dropped);
  REQUIRE(larger.size() == 2);
  REQUIRE(enclosed_area_px(larger[1].chain) == 7 * 4 - 2);
  REQUIRE(drawn.tracer.run(drawn.map, 2, dropped).size() == 3);
  REQUIRE(drawn.tracer.run(drawn.map, 26, dropped).size() == 2);
  REQUIRE(drawn.tracer.run(drawn.map, 27, dropped).size() == 1);
  REQUIRE(dropped == 0);
}

TEST_CASE("chains that find no room are dropped, counted, and not taken up in pieces") {
  // Columns one pixel wide fill the picture: their borders pass every pixel twice.
  for (int height = 60; height < 100; ++height) {
    const cv::Size size(200, height);
    cv::Mat picture(size, CV_8U);
    for (int x = 0; x < size.width; ++x) picture.col(x) = 1 + x % 2;
    DrawnMap drawn(equal_components(picture));
    int dropped = 0;
    const auto traced = drawn.tracer.run(drawn.map, 0, dropped);
    REQUIRE_FALSE(traced.empty());
    REQUIRE(static_cast<int>(traced.size()) + dropped == size.width);
    for (const TracedContour& contour : traced) REQUIRE(contour.external);
  }
}

TEST_CASE("the area enclosed by a chain is that of its polygon") {
  const cv::Mat labels = labels_of_text({".....", ".aaa.", ".aaa.", ".....", "bbbbb"});
  DrawnMap drawn(labels);
  int dropped = 0;
  const auto traced = drawn.tracer.run(drawn.map, 0, dropped);
  REQUIRE(enclosed_area_px(traced[0].chain) == 2);
  REQUIRE(enclosed_area_px(traced[1].chain) == 0);
}

TEST_CASE("a region within another knows it, one at its side or in a bay does not") {
  const cv::Mat labels =
      labels_of_text({"aaaaaaaaaa....", "abbbbaaaaacccc", "abddbaaaaacccc", "abddbaa.aacccc",
                      "abbbbaa.aa....", "aaaaaaaeee....", "aaaaaaaeee....", "aaaaaaaaaa...."});
  DrawnMap drawn(labels);
  int dropped = 0;
  const auto traced = drawn.tracer.run(drawn.map, 0, dropped);
  const auto inside_of = [&](int y, int x) {
    for (const TracedContour& contour : traced)
      if (contour.label == labels.at<int>(y, x) && contour.external)
        return static_cast<int>(contour.inside);
    return -1;
  };
  const int a = labels.at<int>(0, 0), b = labels.at<int>(1, 1);
  REQUIRE(inside_of(0, 0) == 0);
  REQUIRE(inside_of(1, 1) == a);
  REQUIRE(inside_of(2, 2) == b);
  REQUIRE(inside_of(1, 12) == 0);
  REQUIRE(inside_of(5, 8) == 0);
}

}  // namespace aspect
