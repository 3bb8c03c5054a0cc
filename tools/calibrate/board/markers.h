// The markers of ChArUco boards: OpenCV's predefined dictionaries, without OpenCV's contributed
// modules, which bring a desktop's libraries with them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tools/calibrate/board/board.h"

namespace aspect {

inline constexpr int kMarkers = 100;  // of each size

struct PlacedMarker {
  int number = 0, column = 0, row = 0;
};

// Row by row, in the white squares.
std::vector<PlacedMarker> markers_of(const Board& board);

// Cells along a side are `side` + 2, the rim black.
bool is_white_cell(int side, int number, int x, int y);

struct ReadMarker {
  int number = 0;
  int first_corner = 0;  // of what was read, clockwise: where the marker's upper left one is
};

// Which of the first `count` markers these bits are, row by row, as read in one of four turns;
// `wrong_bits` may differ.
std::optional<ReadMarker> find_marker(int side, int count, std::span<const bool> bits,
                                      int wrong_bits);

}  // namespace aspect
