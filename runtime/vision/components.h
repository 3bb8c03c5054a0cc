// Connected components of a picture as runs: the machinery under regions and blobs.
#pragma once

#include <cstdint>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/vision/frame.h"

namespace aspect {

// Pixels [begin, end) of one row that belong together.
struct Run {
  std::uint16_t row = 0, begin = 0, end = 0;
  std::uint16_t label = 0;  // the caller's, 0: none
};

struct ComponentRun : Run {
  std::int32_t root = 0;     // the first run of its component
  std::int32_t area_px = 0;  // of a root: the area of its component
};

// One row's answers, 255 or 0 a pixel, indexed by x: does the pixel count at all, and does it
// belong together with the pixel to the left and the one above?
struct RowLinks {
  const std::uint8_t* counts = nullptr;
  const std::uint8_t* left = nullptr;
  const std::uint8_t* up = nullptr;  // not read in the first row
};

class Components {
 public:
  void take(Arena& arena, int width_px, int height_px);

  // Calls links(y) -> RowLinks for every row of the box, top to bottom. Under 4-connectedness.
  // Rows that find no room are left out and counted in dropped_rows(). O(pixels).
  template <typename Links>
  std::span<ComponentRun> run(const Box& box, Links&& links) {
    begin(box);
    for (int y = box.y; y < box.y + box.height; ++y) {
      const RowLinks row = links(y);
      if (!add_row(y, row)) break;
      if (y > box.y) join_rows(y, row.up);
    }
    return finish();
  }

  // The run of the last result that holds a pixel, which must be in one.
  const ComponentRun& run_at(int x, int y) const;
  int dropped_rows() const { return dropped_rows_; }

 private:
  void begin(const Box& box);
  bool add_row(int y, const RowLinks& links);
  void join_rows(int y, const std::uint8_t* up);
  std::span<ComponentRun> finish();
  std::int32_t root_of(std::int32_t run);
  void join(std::int32_t a, std::int32_t b);

  std::span<ComponentRun> runs_;
  std::span<std::int32_t> row_first_run_;
  Box box_;
  std::int32_t count_ = 0;
  int dropped_rows_ = 0;
};

// First index in [from, end) whose byte differs from `value` (0 or 255), eight at a time.
int end_of_bytes(const std::uint8_t* bytes, int from, int end, std::uint8_t value);

}  // namespace aspect
