// Idea: dark quadrilaterals whose cells are one of the board's markers give the board's place
// coarsely; corners between squares are then where the picture has them.
//   1. thresholds against the surroundings, at three sizes of these, for near boards and far ones
//   2. outlines with four corners; their cells read through the homography of the corners
//   3. markers that disagree with the others' homography are chance, and dropped
//   4. every corner beside a marker: where the homographies of those markers have it, then
//      cornerSubPix within what is free of other edges
// Weak side: a marker below some 3 pixels a cell is not read. Source: Garrido-Jurado et al. 2014;
// the local homographies are those of OpenCV's aruco module.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "tools/calibrate/board/markers.h"
#include "tools/calibrate/camera/board_corners.h"

namespace aspect {
namespace {

using Quad = std::array<cv::Point2f, 4>;  // clockwise in the picture

constexpr int kMostCells = 8;

struct SeenMarker {
  PlacedMarker marker;
  Quad corners;  // from the marker's upper left one on
};

cv::Mat homography(const Quad& from, const Quad& to) {
  return cv::getPerspectiveTransform(from.data(), to.data());
}

cv::Point2f mapped(const cv::Mat& h, double x, double y) {
  const double w = h.at<double>(2, 0) * x + h.at<double>(2, 1) * y + h.at<double>(2, 2);
  return {static_cast<float>(
              (h.at<double>(0, 0) * x + h.at<double>(0, 1) * y + h.at<double>(0, 2)) / w),
          static_cast<float>(
              (h.at<double>(1, 0) * x + h.at<double>(1, 1) * y + h.at<double>(1, 2)) / w)};
}

double side_px(const Quad& quad) {
  double least = 1e9;
  for (std::size_t k = 0; k < 4; ++k)
    least = std::min(least, cv::norm(quad[k] - quad[(k + 1) % 4]));
  return least;
}

void add_quads(const cv::Mat& dark, std::vector<Quad>& quads) {
  constexpr double kLeastSide_px = 10, kFit = 0.04;
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(dark, outlines, cv::RETR_LIST, cv::CHAIN_APPROX_NONE);
  std::vector<cv::Point> corners;
  for (const auto& outline : outlines) {
    if (static_cast<double>(outline.size()) < 4 * kLeastSide_px) continue;
    cv::approxPolyDP(outline, corners, kFit * static_cast<double>(outline.size()), true);
    if (corners.size() != 4 || !cv::isContourConvex(corners)) continue;
    Quad quad;
    std::copy(corners.begin(), corners.end(), quad.begin());
    if (cv::contourArea(corners, true) < 0) std::swap(quad[1], quad[3]);
    if (side_px(quad) >= kLeastSide_px) quads.push_back(quad);
  }
}

// The mean grey of each cell's inner part.
std::vector<double> cell_greys(const cv::Mat& grey, const Quad& quad, int cells) {
  constexpr int kSamples = 3;
  const auto last = static_cast<float>(cells);
  const cv::Mat h = homography({{{0, 0}, {last, 0}, {last, last}, {0, last}}}, quad);
  std::vector<double> greys;
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      double sum = 0;
      for (int s = 0; s < kSamples * kSamples; ++s) {
        const cv::Point2f p =
            mapped(h, x + 0.3 + 0.2 * (s % kSamples), y + 0.3 + 0.2 * (s / kSamples));
        sum += grey.at<std::uint8_t>(std::clamp(cvRound(p.y), 0, grey.rows - 1),
                                     std::clamp(cvRound(p.x), 0, grey.cols - 1));
      }
      greys.push_back(sum / (kSamples * kSamples));
    }
  return greys;
}

std::optional<ReadMarker> read_marker(const cv::Mat& grey, const Quad& quad, const Board& board) {
  constexpr double kLeastContrast = 25;
  const int side = board.marker_side, cells = side + 2;
  const std::vector<double> greys = cell_greys(grey, quad, cells);
  const auto [darkest, lightest] = std::minmax_element(greys.begin(), greys.end());
  if (*lightest - *darkest < kLeastContrast) return std::nullopt;
  const double middle = (*darkest + *lightest) / 2;
  std::array<bool, kMostCells * kMostCells> bits{};
  int rim_faults = 0;
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      const bool white = greys[static_cast<std::size_t>(y * cells + x)] > middle;
      if (x == 0 || y == 0 || x == cells - 1 || y == cells - 1)
        rim_faults += white;
      else
        bits[static_cast<std::size_t>((y - 1) * side + x - 1)] = white;
    }
  if (rim_faults > 1) return std::nullopt;
  // Markers of 4 x 4 differ from each other in three bits at least, larger ones in more.
  const int count = board.columns * board.rows / 2;
  return find_marker(side, count, {bits.data(), static_cast<std::size_t>(side * side)},
                     side == 4 ? 0 : 1);
}

std::vector<SeenMarker> read_markers(const cv::Mat& grey, const Board& board) {
  std::vector<Quad> quads;
  const int shorter = std::min(grey.cols, grey.rows);
  for (const int part : {40, 16, 6}) {
    cv::Mat dark;
    cv::adaptiveThreshold(grey, dark, 255, cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY_INV,
                          std::max(3, shorter / part) | 1, 7);
    add_quads(dark, quads);
  }
  const std::vector<PlacedMarker> placed = markers_of(board);
  std::map<int, SeenMarker> best;  // by number; the largest, which is the marker's outer outline
  for (const Quad& quad : quads) {
    const auto read = read_marker(grey, quad, board);
    if (!read) continue;
    SeenMarker seen{placed[static_cast<std::size_t>(read->number)], quad};
    std::rotate_copy(quad.begin(), quad.begin() + read->first_corner, quad.end(),
                     seen.corners.begin());
    const auto known = best.find(read->number);
    if (known == best.end() || side_px(known->second.corners) < side_px(quad))
      best.insert_or_assign(read->number, seen);
  }
  std::vector<SeenMarker> markers;
  for (const auto& [number, marker] : best) markers.push_back(marker);
  return markers;
}

// Of the board, in mm.
Quad corners_mm(const Board& board, const PlacedMarker& marker) {
  const double free = (board.square_mm - board.marker_mm) / 2;
  const auto left = static_cast<float>(marker.column * board.square_mm + free),
             top = static_cast<float>(marker.row * board.square_mm + free),
             side = static_cast<float>(board.marker_mm);
  return {{{left, top}, {left + side, top}, {left + side, top + side}, {left, top + side}}};
}

// A lens bends a board by a few hundredths of its size; what is farther off was read by chance.
void drop_chance_finds(const Board& board, std::vector<SeenMarker>& markers) {
  constexpr std::size_t kLeast = 4;
  if (markers.size() < kLeast) return;
  std::vector<cv::Point2f> from, to;
  for (const SeenMarker& seen : markers)
    for (std::size_t k = 0; k < 4; ++k) {
      from.push_back(corners_mm(board, seen.marker)[k]);
      to.push_back(seen.corners[k]);
    }
  const cv::Rect2f box = cv::boundingRect(to);
  std::vector<std::uint8_t> inside;
  cv::findHomography(from, to, cv::RANSAC, 0.04 * std::max<double>(box.width, box.height), inside);
  if (inside.size() != from.size()) return markers.clear();
  std::vector<SeenMarker> kept;
  for (std::size_t m = 0; m < markers.size(); ++m)
    if (inside[4 * m] != 0 && inside[4 * m + 1] != 0 && inside[4 * m + 2] != 0 &&
        inside[4 * m + 3] != 0)
      kept.push_back(markers[m]);
  markers = std::move(kept);
}

// Where the markers beside a corner have it, and how far edges of other things are.
struct ExpectedCorner {
  cv::Point2f sum{0, 0};
  int markers = 0;
  double free_px = 1e9;
};

std::map<int, ExpectedCorner> expected_corners(const Board& board,
                                               const std::vector<SeenMarker>& markers) {
  std::map<int, ExpectedCorner> corners;
  for (const SeenMarker& seen : markers) {
    const cv::Mat h = homography(corners_mm(board, seen.marker), seen.corners);
    const double free =
        side_px(seen.corners) / board.marker_mm * (board.square_mm - board.marker_mm) / 2;
    for (int k = 0; k < 4; ++k) {
      const int column = seen.marker.column + k % 2, row = seen.marker.row + k / 2;
      if (column < 1 || row < 1 || column >= board.columns || row >= board.rows) continue;
      ExpectedCorner& corner = corners[(row - 1) * board.corner_columns() + column - 1];
      corner.sum += mapped(h, column * board.square_mm, row * board.square_mm);
      ++corner.markers;
      corner.free_px = std::min(corner.free_px, free);
    }
  }
  return corners;
}

}  // namespace

SeenBoard find_charuco(const cv::Mat& grey, const Board& board) {
  std::vector<SeenMarker> markers = read_markers(grey, board);
  drop_chance_finds(board, markers);
  SeenBoard seen;
  for (const auto& [number, corner] : expected_corners(board, markers)) {
    constexpr int kLeastReach_px = 2, kMostReach_px = 12;
    const int reach = std::clamp(static_cast<int>(corner.free_px), kLeastReach_px, kMostReach_px);
    const cv::Point2f start = corner.sum * (1.0F / static_cast<float>(corner.markers));
    const auto rim = static_cast<float>(reach + 2);
    if (!(start.x >= rim && start.y >= rim && start.x < static_cast<float>(grey.cols) - rim &&
          start.y < static_cast<float>(grey.rows) - rim))
      continue;
    std::vector<cv::Point2f> point{start};
    cv::cornerSubPix(grey, point, {reach, reach}, {-1, -1},
                     {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 0.005});
    // What moved farther than homographies of whole pixels are off has found another edge.
    if (cv::norm(point.front() - start) > std::max(1.5, 0.5 * reach)) continue;
    seen.numbers.push_back(number);
    seen.points.push_back(point.front());
  }
  return seen;
}

}  // namespace aspect
