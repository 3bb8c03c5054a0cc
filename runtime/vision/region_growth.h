// Gives the foreground between the cores of regions to the regions (second half of the stage
// "segment").
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/vision/frame.h"
#include "runtime/vision/share_rows.h"
#include "runtime/vision/vision_limits.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

// Mean colour of the core with label i + 1.
struct CoreColour {
  std::array<std::uint8_t, 3> share{};
  std::uint8_t intensity = 0;  // (r + g + b) / 3
};

// Growth leaves marks of its own in the bits above a label's.
inline constexpr std::uint16_t kLabelMask = 0x0FFF;
static_assert(kMaxRegions <= kLabelMask);

// A picture of labels, 0: none. Pixel x, y stands at y * stride_px + x.
struct LabelPicture {
  std::span<std::uint16_t> labels;
  int stride_px = 0;
  Box active;
};

class RegionGrowth {
 public:
  void take(Arena& arena, int width_px, int height_px);

  void begin() { waiting_count_ = 0; }

  // Foreground pixels [begin, end) of a row that have no label: of a border, or of a flat patch too
  // small for a region. Those that find no room keep none.
  void wait(int y, int begin, int end, bool is_flat);

  // Labels that are given carry marks (kLabelMask). First every waiting pixel that has the colour
  // of a region next to it joins that region, however far that leads; regions of one colour that
  // meet in this way become one (see joined). Then the others, a few layers deep, take the most
  // alike region next to them.
  void run(const ShareRows& shares, std::span<const CoreColour> cores,
           const VisionParameters& parameters, LabelPicture picture);

  // Memory that the next begin() takes back.
  std::span<std::uint8_t> idle_memory() const {
    return {reinterpret_cast<std::uint8_t*>(waiting_.data()), waiting_.size_bytes()};
  }

  // The label that stands for this one after run(): the lowest of its joined regions.
  std::uint16_t joined(std::uint16_t label) const;

 private:
  struct Pixel {
    int x = 0, y = 0;
  };
  struct WaitingRun {
    std::uint16_t row : 15 = 0;
    std::uint16_t is_flat : 1 = 0;
    std::uint16_t begin = 0, end = 0;
  };
  static_assert(kMaxFrameSide_px <= 1 << 15);
  struct Neighbour {
    std::uint16_t label = 0;
    int difference = 512;  // largest of the three shares', and more where intensities differ
  };
  struct Growing;

  std::span<WaitingRun> waiting_;
  std::span<std::uint16_t> parent_;  // by label
  std::size_t room_ = 0, waiting_count_ = 0;
};

}  // namespace aspect
