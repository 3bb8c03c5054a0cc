// Border following after Suzuki and Abe ("Topological structural analysis of digitized binary
// images by border following", 1985), for many labels at once: a row-by-row scan meets each
// border first at a pixel whose west (external) or east (internal) neighbour is of another
// region and was not passed by a trace before; the trace then walks the border once, looking
// round each pixel for the next one. A region is surrounded by another when at least 95 % of the
// pixels met along its external border belong to that one.
#include "runtime/vision/contour_trace.h"

#include <algorithm>
#include <bitset>
#include <cstdlib>

#include "runtime/vision/vision_limits.h"

namespace aspect {
namespace {

constexpr int kMaxTraced = 2 * kMaxRegions;

}  // namespace

// Which other region a border touches most: a majority vote in constant space (Boyer and Moore).
struct ContourTracer::Surrounding {
  std::uint16_t favourite = 0;
  int lead = 0, votes = 0;
  void vote(std::uint16_t label) {
    ++votes;
    if (lead == 0) favourite = label;
    lead += label == favourite ? 1 : -1;
  }
  std::uint16_t winner() const {
    return favourite != 0 && lead * 10 >= votes * 9 ? favourite : std::uint16_t{0};
  }
};

struct ContourTracer::Walk {
  std::uint16_t label = 0;
  int x = 0, y = 0;
  int from = 0;  // direction of the pixel it came from
};

void ContourTracer::take(Arena& arena, int width_px, int height_px) {
  const std::size_t pixels =
      static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
  east_seen_ = arena.take<std::uint64_t>(pixels / 64 + 1);
  contours_ = arena.take<TracedContour>(kMaxTraced);
}

std::uint16_t ContourTracer::label_at(const RegionMap& map, int x, int y) const {
  const Box& box = map.active;
  if (x < box.x || y < box.y || x >= box.x + box.width || y >= box.y + box.height) return 0;
  return map.labels[static_cast<std::size_t>(y * map.stride_px + x)];
}

// Looks round the pixel clockwise, starting behind direction `from`, for the next one of the
// border.
int ContourTracer::next_direction(const RegionMap& map, const Walk& walk,
                                  Surrounding& surrounding) {
  for (int turn = 1; turn <= 8; ++turn) {
    const int direction = (walk.from + turn) & 7;
    const std::uint16_t other =
        label_at(map, walk.x + kStepX[direction], walk.y + kStepY[direction]);
    if (other == walk.label) return direction;
    if (direction == 0) see_east(static_cast<std::size_t>(walk.y * map.stride_px + walk.x));
    if ((direction & 1) == 0) surrounding.vote(other);
  }
  return -1;
}

// Walks a border once round and appends its contour; false where there is no room for it.
bool ContourTracer::trace(const RegionMap& map, int x, int y, bool external) {
  if (contour_count_ == contours_.size()) return false;
  const std::size_t chain_begin = chain_bytes_;
  // The neighbour of another region is west of an external start and east of an internal one.
  Walk walk{label_at(map, x, y), x, y, external ? 4 : 0};
  Surrounding surrounding;
  int first_direction = -1;
  for (;;) {
    const int direction = next_direction(map, walk, surrounding);
    const bool at_start = walk.x == x && walk.y == y;
    if (direction < 0 || (at_start && direction == first_direction)) break;
    if (first_direction < 0) first_direction = direction;
    if (chain_bytes_ == chains_.size()) {
      chain_bytes_ = chain_begin;
      return false;
    }
    chains_[chain_bytes_++] = static_cast<std::uint8_t>(direction);
    walk.x += kStepX[direction];
    walk.y += kStepY[direction];
    walk.from = (direction + 4) & 7;
  }
  TracedContour& contour = contours_[contour_count_++];
  contour.label = walk.label;
  contour.inside = external ? surrounding.winner() : std::uint16_t{0};
  contour.external = external;
  contour.start_x = x;
  contour.start_y = y;
  contour.chain = chains_.subspan(chain_begin, chain_bytes_ - chain_begin);
  return true;
}

void ContourTracer::forget_seen(const RegionMap& map) {
  const Box& box = map.active;
  if (box.empty()) return;
  const auto first = static_cast<std::size_t>(box.y * map.stride_px + box.x);
  const auto last =
      static_cast<std::size_t>((box.y + box.height - 1) * map.stride_px + box.x + box.width - 1);
  std::fill(east_seen_.begin() + static_cast<std::ptrdiff_t>(first / 64),
            east_seen_.begin() + static_cast<std::ptrdiff_t>(last / 64 + 1), std::uint64_t{0});
}

std::span<const TracedContour> ContourTracer::run(const RegionMap& map, int hole_area_min_px,
                                                  int& dropped) noexcept {
  forget_seen(map);
  chain_bytes_ = contour_count_ = 0;
  std::uint16_t highest_traced = 0;  // labels are in the order of their first pixels
  // Borders that found no room are not tried again at each of their pixels.
  std::bitset<kMaxRegions + 1> lost;
  const auto trace_or_lose = [&](const Run& run, int x, bool external) {
    if (trace(map, x, run.row, external)) return true;
    lost.set(run.label);
    ++dropped;
    return false;
  };
  for (const Run& run : map.runs) {
    if (run.label == 0) continue;
    if (run.label > highest_traced) {
      highest_traced = run.label;
      trace_or_lose(run, run.begin, true);
    }
    if (lost.test(run.label)) continue;
    const int last = run.end - 1;
    if (label_at(map, run.end, run.row) == run.label ||
        east_seen(static_cast<std::size_t>(run.row * map.stride_px + last)))
      continue;
    // A line that encloses nothing is no hole, but a piece of a region that lost its lowest rows.
    if (trace_or_lose(run, last, false) &&
        enclosed_area_px(contours_[contour_count_ - 1].chain) < std::max(hole_area_min_px, 1))
      chain_bytes_ -= contours_[--contour_count_].chain.size();
  }
  return contours_.first(contour_count_);
}

double enclosed_area_px(std::span<const std::uint8_t> chain) {
  std::int64_t twice = 0, x = 0, y = 0;
  for (const std::uint8_t code : chain) {
    twice += x * kStepY[code] - y * kStepX[code];
    x += kStepX[code];
    y += kStepY[code];
  }
  return static_cast<double>(std::abs(twice)) / 2;
}

}  // namespace aspect
