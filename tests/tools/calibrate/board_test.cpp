// Boards against OpenCV's own and against what a ruler would say.
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "tools/calibrate/board/board_page.h"
#include "tools/calibrate/board/markers.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

Board charuco(int columns, int rows, double square_mm, double marker_mm, int side) {
  Board board;
  board.kind = Board::Kind::charuco;
  board.columns = columns;
  board.rows = rows;
  board.square_mm = square_mm;
  board.marker_mm = marker_mm;
  board.marker_side = side;
  return board;
}

double area_of(const std::vector<BlackBox>& boxes) {
  double area = 0;
  for (const BlackBox& box : boxes) area += box.width_mm * box.height_mm;
  return area;
}

TEST_CASE("A ChArUco board is the one that OpenCV draws, square by square and cell by cell") {
  // cv2.aruco.CharucoBoard_create(6, 5, 30, 24, DICT_5X5_100).draw((210, 175)) of OpenCV 4.6; its
  // markers are drawn 28 pixels wide.
  const cv::Mat theirs = cv::imread(
      ASPECT_SOURCE_DIR "/tests/tools/calibrate/data/charuco_5x5_opencv.png", cv::IMREAD_GRAYSCALE);
  REQUIRE(theirs.cols == 210);
  // All of each square that has no marker.
  const Board board = charuco(6, 5, 30, 24, 5);
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 6; ++column)
      if (board.is_black(column, row))
        CHECK(cv::countNonZero(theirs(cv::Rect(column * 35, row * 35, 35, 35))) == 0);
  for (const PlacedMarker& marker : markers_of(board))
    for (int y = 0; y < 7; ++y)
      for (int x = 0; x < 7; ++x) {
        INFO("marker " << marker.number << " cell " << x << " " << y);
        const int px = marker.column * 35 + 3 + 4 * x + 2, py = marker.row * 35 + 3 + 4 * y + 2;
        CHECK((theirs.at<std::uint8_t>(py, px) > 0) == is_white_cell(5, marker.number, x, y));
      }
}

TEST_CASE("Squares of a checkerboard are black in turn, from the upper left one on") {
  Board board;
  board.columns = 4;
  board.rows = 3;
  board.square_mm = 10;
  const std::vector<BlackBox> boxes = black_boxes(board);
  CHECK(boxes.size() == 6);
  CHECK(area_of(boxes) == Approx(600));
  CHECK(boxes[0].x_mm == 0);
  CHECK(boxes[1].x_mm == 20);
  CHECK(boxes[2].x_mm == 10);
  CHECK(boxes[2].y_mm == 10);
  CHECK(board.corners() == 6);
  CHECK(board.corner_mm(4).x == 20);
  CHECK(board.corner_mm(4).y == 20);
}

TEST_CASE("A marker is read in every turn, and with a wrong bit where that is allowed") {
  for (const int side : {4, 5, 6})
    for (const int number : {0, 7, 34, 99}) {
      std::vector<bool> read;
      for (int y = 1; y <= side; ++y)
        for (int x = 1; x <= side; ++x) read.push_back(is_white_cell(side, number, x, y));
      for (int turns = 0; turns < 4; ++turns) {
        INFO(side << " " << number << " " << turns);
        std::unique_ptr<bool[]> bits(new bool[read.size()]);
        std::copy(read.begin(), read.end(), bits.get());
        const std::span<const bool> all(bits.get(), read.size());
        const auto found = find_marker(side, 100, all, 0);
        REQUIRE(found);
        CHECK(found->number == number);
        CHECK(found->first_corner == turns);
        bits[3] = !bits[3];
        CHECK(find_marker(side, 100, all, 0) == std::nullopt);
        if (side > 4) CHECK(find_marker(side, 100, all, 1)->number == number);
        // A quarter clockwise: the upper left corner is the next one then.
        std::vector<bool> turned(read.size());
        for (int y = 0; y < side; ++y)
          for (int x = 0; x < side; ++x)
            turned[static_cast<std::size_t>(x * side + side - 1 - y)] =
                read[static_cast<std::size_t>(y * side + x)];
        read = turned;
      }
    }
}

TEST_CASE("A printed board is true to scale in PDF and SVG") {
  const Board board = charuco(9, 7, 27, 20, 4);
  double expected = area_of(black_boxes(board));
  expected += 100 * 0.2 + 2 * 0.2 * 2;  // the ruler
  for (const Paper& paper : {kA4, kLetter}) {
    const auto pdf = board_pdf(board, paper);
    REQUIRE(pdf);
    CHECK_THAT(pdf.value(), StartsWith("%PDF-1.4") && Contains("/PrintScaling /None"));
    // The board lies, and so does the paper.
    const double long_pt = paper.height_mm * 72 / 25.4, short_pt = paper.width_mm * 72 / 25.4;
    double width = 0, height = 0;
    REQUIRE(std::sscanf(pdf.value().c_str() + pdf.value().find("/MediaBox"),
                        "/MediaBox [0 0 %lf %lf]", &width, &height) == 2);
    CHECK(width == Approx(long_pt).margin(0.01));
    CHECK(height == Approx(short_pt).margin(0.01));
    std::istringstream lines(pdf.value());
    double area = 0, scale = 0, ignored = 0;
    for (std::string line; std::getline(lines, line);) {
      double x = 0, y = 0, w = 0, h = 0;
      if (line.ends_with(" cm"))
        REQUIRE(std::sscanf(line.c_str(), "%lf %lf %lf %lf", &scale, &ignored, &ignored, &h) == 4);
      if (line.ends_with(" re") &&
          std::sscanf(line.c_str(), "%lf %lf %lf %lf", &x, &y, &w, &h) == 4) {
        area += w * h;
        CHECK(x >= 5);
        CHECK(x + w <= paper.height_mm - 5);
        CHECK(y + h <= paper.width_mm - 5);
      }
    }
    CHECK(scale == Approx(72 / 25.4).margin(1e-5));
    CHECK(area == Approx(expected).epsilon(1e-4));
    const auto svg = board_svg(board, paper);
    REQUIRE(svg);
    CHECK_THAT(svg.value(), Contains("mm\" viewBox=\"0 0 "));
  }
}

TEST_CASE("Where the cross references of a PDF point, objects begin") {
  const std::string pdf = board_pdf(Board(), kA4).value();
  const std::size_t table = pdf.find("xref\n");
  CHECK_THAT(pdf, Contains("startxref\n" + std::to_string(table) + "\n"));
  std::istringstream entries(pdf.substr(table));
  std::string line;
  for (int skipped = 0; skipped < 3; ++skipped) std::getline(entries, line);
  for (int number = 1; number <= 5; ++number) {
    std::getline(entries, line);
    CHECK(line.size() == 19);  // 20 bytes with its end
    CHECK(pdf.substr(std::stoul(line), 8) == std::to_string(number) + " 0 obj\n");
  }
}

TEST_CASE("Boards that no paper holds or no camera tells apart are refused") {
  Board large;
  large.square_mm = 40;
  CHECK_THAT(board_pdf(large, kA4).error(), Contains("squares of 27.") && Contains("do not fit"));
  large.square_mm = 27;
  CHECK(board_pdf(large, kA4));
  CHECK_FALSE(checked_board(charuco(2, 7, 25, 18, 4)));
  CHECK_FALSE(checked_board(charuco(10, 7, 25, 25, 4)));
  CHECK_FALSE(checked_board(charuco(10, 7, 25, 18, 7)));
  CHECK_FALSE(checked_board(charuco(20, 20, 25, 18, 4)));
  CHECK_FALSE(checked_board(charuco(10, 7, std::nan(""), 18, 4)));
  CHECK(checked_board(charuco(14, 14, 25, 18, 4)));
}

}  // namespace
}  // namespace aspect
