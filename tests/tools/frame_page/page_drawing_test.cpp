// What is drawn over a frame: filled by OpenCV, a region's path is the region.
#include "tools/frame_page/page_drawing.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/runtime/vision/pictures.h"
#include "tests/tools/frame_page/svg_path.h"
#include "tools/frame_page/page_picture.h"

namespace aspect {
namespace {

cv::Mat filled(const std::string& path, cv::Size size) {
  std::vector<std::vector<cv::Point>> polygons;
  for (const auto& line : points_of_path(path)) {
    polygons.emplace_back();
    for (const cv::Point2d& p : line) polygons.back().emplace_back(cvRound(p.x), cvRound(p.y));
  }
  cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
  cv::fillPoly(mask, polygons, 255);
  return mask;
}

double overlap(const cv::Mat& a, const cv::Mat& b) {
  return static_cast<double>(cv::countNonZero(a & b)) / cv::countNonZero(a | b);
}

std::vector<std::uint8_t> bytes_of_uri(const std::string& uri) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  unsigned bits = 0, count = 0;
  for (std::size_t k = uri.find(',') + 1; k < uri.size() && uri[k] != '='; ++k) {
    bits = bits << 6U | static_cast<unsigned>(letters.find(uri[k]));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> count));
  }
  return bytes;
}

}  // namespace

TEST_CASE("A region's path, filled, is the region with its holes") {
  cv::Mat picture = cv::Mat::zeros(240, 320, CV_8UC3);
  cv::circle(picture, {110, 120}, 90, {200, 20, 20}, cv::FILLED);
  cv::circle(picture, {110, 110}, 40, {0, 0, 0}, cv::FILLED);
  cv::rectangle(picture, cv::Rect(100, 100, 24, 20), {20, 200, 20}, cv::FILLED);
  cv::rectangle(picture, cv::Rect(230, 30, 60, 150), {20, 20, 220}, cv::FILLED);
  OwnedVision vision(320, 240);
  const ViewGraph graph = vision.run(picture, exact_parameters());
  const nlohmann::json contours = contours_json(graph, vision.regions());
  CHECK(contours["left_out"] == 0);
  REQUIRE(contours["shown"].size() == 3);
  const cv::Mat labels = label_picture(vision.regions(), picture.size());
  for (const nlohmann::json& shown : contours["shown"]) {
    const Contour& contour = graph.contours[shown["n"].get<std::size_t>()];
    const cv::Mat region = mask_of(labels, contour.region);
    CHECK(overlap(filled(shown["path"], picture.size()), region) > 0.93);
    const cv::Point at(shown["at"][0].get<int>(), shown["at"][1].get<int>());
    CHECK(region.at<std::uint8_t>(at) == 255);
  }
  CHECK(contours["shown"][0]["colour"] == "#c81414");
}

TEST_CASE("A frame full of things takes no more room than it may, and says what is left out") {
  std::mt19937 random(3);
  cv::Mat picture = cv::Mat::zeros(480, 640, CV_8UC3);
  for (int k = 0; k < 900; ++k)
    cv::circle(picture, {static_cast<int>(random() % 640), static_cast<int>(random() % 480)},
               6 + static_cast<int>(random() % 9), colour(static_cast<int>(random() % 8)),
               cv::FILLED);
  OwnedVision vision(640, 3 * 480);
  const ViewGraph graph = vision.run(picture, exact_parameters());
  const nlohmann::json contours = contours_json(graph, vision.regions());
  CHECK(contours.dump().size() < kMostContourBytes * 5 / 4);
  const auto external = std::count_if(graph.contours.begin(), graph.contours.end(),
                                      [](const Contour& contour) { return contour.external; });
  CHECK(contours["left_out"].get<std::size_t>() > 0);
  CHECK(static_cast<std::ptrdiff_t>(contours["shown"].size() +
                                    contours["left_out"].get<std::size_t>()) == external);
}

TEST_CASE("A model's lines keep their places, with fewer points") {
  PictureLine straight, bent;
  for (int k = 0; k <= 50; ++k) straight.push_back({10.25 + 2 * k, 300.5 - k});
  for (int k = 0; k <= 60; ++k)
    bent.push_back({200 + 80 * std::cos(k * 0.05), 150 + 80 * std::sin(k * 0.05)});
  const std::vector<PictureLine> lines = {straight, bent};
  const auto points = points_of_path(path_of(lines));
  REQUIRE(points.size() == 2);
  CHECK(points[0].size() == 2);
  CHECK(points[1].size() < 20);
  for (std::size_t k = 0; k < 2; ++k) {
    std::vector<cv::Point2f> drawn(points[k].begin(), points[k].end());
    // Closed on itself: what lies on the line is at distance 0 from the flat polygon.
    for (std::size_t back = points[k].size(); back-- > 0;) drawn.emplace_back(points[k][back]);
    for (const Point2d& p : lines[k])
      CHECK(std::abs(cv::pointPolygonTest(drawn, cv::Point2f(cv::Point2d(p.x, p.y)), true)) < 0.7);
  }
}

TEST_CASE("A picture in the page is the frame, made smaller where it is large") {
  cv::Mat picture(960, 1280, CV_8UC3);
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x)
      picture.at<cv::Vec3b>(y, x) =
          cv::Vec3b(static_cast<std::uint8_t>(x / 6), static_cast<std::uint8_t>(y / 4), 90);
  for (const int side : {512, 1280}) {
    const cv::Mat frame_picture = picture(cv::Rect(0, 0, side, side * 3 / 4)).clone();
    const Frame frame = {frame_picture.data, side, side * 3 / 4, std::ptrdiff_t{3} * side,
                         PixelFormat::bgr8};
    const std::string uri = picture_uri(frame);
    CHECK(uri.starts_with("data:image/webp;base64,"));
    const std::vector<std::uint8_t> bytes = bytes_of_uri(uri);
    CHECK(bytes.size() <= kMostPagePictureBytes);
    const cv::Mat read = cv::imdecode(bytes, cv::IMREAD_COLOR);
    REQUIRE(read.cols == std::min(side, kMostPagePictureSide_px));
    REQUIRE(read.rows == read.cols * 3 / 4);
    cv::Mat expected;
    cv::resize(frame_picture, expected, read.size(), 0, 0, cv::INTER_AREA);
    CHECK(cv::PSNR(read, expected) > 32);
  }
}

}  // namespace aspect
