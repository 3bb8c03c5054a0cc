// The inner corners of a board in a picture.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "tools/calibrate/board/board.h"

namespace aspect {

// As found: numbers and places of corners, pixel centres at whole numbers.
struct SeenBoard {
  std::vector<int> numbers;
  std::vector<cv::Point2f> points;
  bool empty() const { return numbers.empty(); }
};

// Four corners that are not in a line: others say nothing of the board's place.
bool spans_an_area(const SeenBoard& seen, const Board& board);

// Of 8 bits, grey. Empty where there is no board; a checkerboard must be seen as a whole, of a
// ChArUco board as little as four corners that are not in a line.
SeenBoard find_board(const cv::Mat& grey, const Board& board);

// A checkerboard by its saddle points (Duda and Frese, Accurate detection and localization of
// checkerboard corners for calibration, 2018), as OpenCV has it.
SeenBoard find_checkerboard(const cv::Mat& grey, const Board& board);

// By its markers; then each corner from the nearest ones, to a part of a pixel.
SeenBoard find_charuco(const cv::Mat& grey, const Board& board);

}  // namespace aspect
