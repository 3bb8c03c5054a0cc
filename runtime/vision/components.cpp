// Neighbours on a row form a run; runs of adjacent rows are joined by union-find where a pair of
// pixels, one above the other, belongs together. The first run of a set is its root, so the result
// does not depend on the order of the joins (Rosenfeld and Pfaltz 1966, on runs).
#include "runtime/vision/components.h"

#include <algorithm>
#include <cstring>

#include "runtime/vision/vision_limits.h"

namespace aspect {

int end_of_bytes(const std::uint8_t* bytes, int from, int end, std::uint8_t value) {
  std::uint64_t pattern = 0;
  std::memset(&pattern, value, sizeof pattern);
  while (from + 8 <= end) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes + from, sizeof word);
    if (word != pattern) break;
    from += 8;
  }
  while (from < end && bytes[from] == value) ++from;
  return from;
}

void Components::take(Arena& arena, int width_px, int height_px) {
  const auto width = static_cast<std::size_t>(width_px);
  const auto height = static_cast<std::size_t>(height_px);
  runs_ = arena.take<ComponentRun>(width * height / kRunsPerPixelDivisor + width);
  row_first_run_ = arena.take<std::int32_t>(height + 1);
}

void Components::begin(const Box& box) {
  box_ = box;
  count_ = 0;
  dropped_rows_ = 0;
  std::fill_n(row_first_run_.begin() + box.y, box.height + 1, 0);
}

bool Components::add_row(int y, const RowLinks& links) {
  const int end = box_.x + box_.width;
  row_first_run_[static_cast<std::size_t>(y)] = count_;
  for (int x = end_of_bytes(links.counts, box_.x, end, 0); x < end;) {
    if (count_ == static_cast<std::int32_t>(runs_.size())) {
      dropped_rows_ = box_.y + box_.height - y;
      count_ = row_first_run_[static_cast<std::size_t>(y)];
      std::fill_n(row_first_run_.begin() + y, dropped_rows_ + 1, count_);
      return false;
    }
    const int stop = end_of_bytes(links.left, x + 1, end, 255);
    ComponentRun& run = runs_[static_cast<std::size_t>(count_)];
    run = {{static_cast<std::uint16_t>(y), static_cast<std::uint16_t>(x),
            static_cast<std::uint16_t>(stop), 0},
           count_,
           0};
    ++count_;
    x = end_of_bytes(links.counts, stop, end, 0);
  }
  row_first_run_[static_cast<std::size_t>(y) + 1] = count_;
  return true;
}

void Components::join_rows(int y, const std::uint8_t* up) {
  const auto row = static_cast<std::size_t>(y);
  std::int32_t above = row_first_run_[row - 1], here = row_first_run_[row];
  const std::int32_t above_end = here, here_end = count_;
  while (above < above_end && here < here_end) {
    const Run& a = runs_[static_cast<std::size_t>(above)];
    const Run& b = runs_[static_cast<std::size_t>(here)];
    const int begin = std::max(a.begin, b.begin), end = std::min(a.end, b.end);
    if (begin < end && end_of_bytes(up, begin, end, 0) < end) join(above, here);
    if (a.end < b.end)
      ++above;
    else
      ++here;
  }
}

std::span<ComponentRun> Components::finish() {
  for (std::int32_t i = 0; i < count_; ++i) {
    ComponentRun& run = runs_[static_cast<std::size_t>(i)];
    run.root = root_of(i);
    runs_[static_cast<std::size_t>(run.root)].area_px += run.end - run.begin;
  }
  return runs_.first(static_cast<std::size_t>(count_));
}

std::int32_t Components::root_of(std::int32_t run) {
  const auto at = [this](std::int32_t i) -> std::int32_t& {
    return runs_[static_cast<std::size_t>(i)].root;
  };
  while (at(run) != run) {
    at(run) = at(at(run));
    run = at(run);
  }
  return run;
}

void Components::join(std::int32_t a, std::int32_t b) {
  a = root_of(a);
  b = root_of(b);
  runs_[static_cast<std::size_t>(std::max(a, b))].root = std::min(a, b);
}

const ComponentRun& Components::run_at(int x, int y) const {
  const auto row = static_cast<std::size_t>(y);
  const auto first = runs_.begin() + row_first_run_[row];
  const auto last = runs_.begin() + row_first_run_[row + 1];
  const auto after =
      std::upper_bound(first, last, x, [](int value, const Run& run) { return value < run.begin; });
  return *(after - 1);
}

}  // namespace aspect
