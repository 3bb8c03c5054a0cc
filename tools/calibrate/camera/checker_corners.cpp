#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "tools/calibrate/camera/board_corners.h"

namespace aspect {
namespace {

// The saddle points alone leave a bias where a board is tilted: of ten sets of twelve pictures
// (make_board_pictures) the worst focal length was 0.44 % off, and 0.08 % with this after it. The
// window is as large as squares that are seen smallest allow.
void refine(const cv::Mat& grey, const Board& board, std::vector<cv::Point2f>& points) {
  constexpr double kShare = 0.4;
  constexpr int kLeast_px = 2, kMost_px = 15;
  double smallest = 1e9;
  for (int k = 0; k < board.corners(); ++k) {
    const auto at = [&](int number) { return points[static_cast<std::size_t>(number)]; };
    if (k % board.corner_columns() > 0) smallest = std::min(smallest, cv::norm(at(k) - at(k - 1)));
    if (k >= board.corner_columns())
      smallest = std::min(smallest, cv::norm(at(k) - at(k - board.corner_columns())));
  }
  const int reach = std::clamp(static_cast<int>(kShare * smallest), kLeast_px, kMost_px);
  cv::cornerSubPix(grey, points, {reach, reach}, {-1, -1},
                   {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 60, 0.001});
}

}  // namespace

SeenBoard find_checkerboard(const cv::Mat& grey, const Board& board) {
  SeenBoard seen;
  std::vector<cv::Point2f> points;
  if (!cv::findChessboardCornersSB(grey, {board.corner_columns(), board.corner_rows()}, points,
                                   cv::CALIB_CB_ACCURACY | cv::CALIB_CB_NORMALIZE_IMAGE))
    return seen;
  refine(grey, board, points);
  for (int number = 0; number < static_cast<int>(points.size()); ++number)
    seen.numbers.push_back(number);
  seen.points = std::move(points);
  return seen;
}

bool spans_an_area(const SeenBoard& seen, const Board& board) {
  constexpr std::size_t kLeast = 4;
  bool columns_differ = false, rows_differ = false;
  for (const int number : seen.numbers) {
    columns_differ |=
        number % board.corner_columns() != seen.numbers.front() % board.corner_columns();
    rows_differ |= number / board.corner_columns() != seen.numbers.front() / board.corner_columns();
  }
  return columns_differ && rows_differ && seen.numbers.size() >= kLeast;
}

SeenBoard find_board(const cv::Mat& grey, const Board& board) {
  const SeenBoard seen = board.kind == Board::Kind::charuco ? find_charuco(grey, board)
                                                            : find_checkerboard(grey, board);
  if (!spans_an_area(seen, board)) return {};
  return seen;
}

}  // namespace aspect
