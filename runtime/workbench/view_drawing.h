// What the page shows of a frame: the picture, its regions and the edges of what stands in it. The
// browser draws; here is only found what to draw. All of it on the page's thread.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/base/planned_memory.h"
#include "runtime/vision/vision.h"
#include "runtime/workbench/frame_copy.h"

namespace aspect {

struct ViewLabel {
  std::uint64_t view = 0;      // its number
  std::uint64_t line = 0;      // of the line that belongs to the frame
  std::uint64_t settings = 0;  // of the values that it was cut with
};

class ViewDrawing {
 public:
  // Pictures are scaled down to this at most; regions and edges are in the frame's pixels.
  static constexpr int kWidth_px = 640, kHeight_px = 480;

  // Four bytes with the length of a JSON object, little-endian; the object; a BMP; the runs of the
  // regions, four numbers of 16 bits each: row, begin, end, label. `models` by index.
  std::string draw(const FrameCopy& copy, const VisionParameters& vision,
                   const std::vector<ObjectModel>& models, const ViewLabel& label);

 private:
  const RegionMap* cut(const Frame& frame, const VisionParameters& vision);

  PlannedMemory memory_;
  Vision vision_;
  SensorKind sensor_ = SensorKind::colour;
  int width_px_ = 0, height_px_ = 0;
};

}  // namespace aspect
