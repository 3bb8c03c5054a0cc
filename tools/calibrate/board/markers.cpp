#include "tools/calibrate/board/markers.h"

#include <array>
#include <bit>
#include <cstddef>

namespace aspect {
namespace {

#include "tools/calibrate/board/marker_table.inc"

std::uint64_t bits_of(int side, int number) {
  const auto place = static_cast<std::size_t>(number);
  return side == 4 ? kMarkers4[place] : side == 5 ? kMarkers5[place] : kMarkers6[place];
}

}  // namespace

std::vector<PlacedMarker> markers_of(const Board& board) {
  std::vector<PlacedMarker> markers;
  for (int row = 0; row < board.rows; ++row)
    for (int column = 0; column < board.columns; ++column)
      if (!board.is_black(column, row))
        markers.push_back({static_cast<int>(markers.size()), column, row});
  return markers;
}

bool is_white_cell(int side, int number, int x, int y) {
  if (x == 0 || y == 0 || x == side + 1 || y == side + 1) return false;
  const int place = side * side - 1 - ((y - 1) * side + x - 1);
  return (bits_of(side, number) >> static_cast<unsigned>(place) & 1U) != 0;
}

std::optional<ReadMarker> find_marker(int side, int count, std::span<const bool> bits,
                                      int wrong_bits) {
  for (int turns = 0; turns < 4; ++turns) {
    std::uint64_t word = 0;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        // Where the cell at x, y of the upright marker is in what was read.
        int u = x, v = y;
        for (int turn = 0; turn < turns; ++turn) {
          const int w = u;
          u = v;
          v = side - 1 - w;
        }
        word = word << 1U | (bits[static_cast<std::size_t>(v * side + u)] ? 1U : 0U);
      }
    for (int number = 0; number < count; ++number)
      if (std::popcount(word ^ bits_of(side, number)) <= wrong_bits)
        return ReadMarker{number, (4 - turns) % 4};
  }
  return std::nullopt;
}

}  // namespace aspect
