// Gives the foreground between the cores of regions to the regions (second half of the stage
// "segment").
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/vision/enhance.h"
#include "runtime/vision/frame.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

// Mean colour of the core with label i + 1.
struct CoreColour {
  std::array<std::uint8_t, 3> share{};
  std::uint8_t intensity = 0;  // (r + g + b) / 3
};

// A picture of labels, 0: none. Pixel x, y stands at y * stride_px + x.
struct LabelPicture {
  std::span<std::uint16_t> labels;
  int stride_px = 0;
  Box active;
};

class RegionGrowth {
 public:
  void take(Arena& arena, int width_px, int height_px);

  void begin() { pending_count_ = 0; }

  // Foreground pixels [begin, end) of a row that have no label. Those that find no room keep none.
  void wait(int y, int begin, int end);

  // First every waiting pixel that has the colour of a region next to it joins that region, however
  // far that leads; regions of one colour that meet in this way become one (see joined). Then the
  // others, a few layers deep, take the most alike region next to them.
  void run(const Shares& shares, std::span<const CoreColour> cores,
           const VisionParameters& parameters, LabelPicture picture);

  // The label that stands for this one after run(): the lowest of its joined regions.
  std::uint16_t joined(std::uint16_t label) const;

 private:
  struct Pixel {
    std::uint16_t x = 0, y = 0;
  };
  struct Neighbour {
    std::uint16_t label = 0;
    int difference = 512;  // largest of the three shares', and more where intensities differ
  };
  struct Growing;

  std::span<Pixel> pending_;
  std::span<std::uint16_t> pending_label_;
  std::span<std::uint16_t> parent_;  // by label
  std::size_t pending_count_ = 0;
};

}  // namespace aspect
