// Where frames come from: a camera, recorded files, test patterns.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/vision/frame.h"

namespace aspect {

// A frame with the memory that it is in; reused from frame to frame it stops allocating.
struct CapturedFrame {
  std::string name;            // of the file, the video with the frame's number, or the camera
  std::uint64_t sequence = 0;  // place among all frames of the source, lost ones counted
  int width_px = 0, height_px = 0;
  PixelFormat format = PixelFormat::bgr8;
  std::vector<std::uint8_t> pixels;  // row by row without gaps
  std::string error;                 // one line that names the file; only of a failed frame

  Frame view() const {
    return {pixels.data(), width_px, height_px, std::ptrdiff_t{bytes_per_pixel(format)} * width_px,
            format};
  }
};

enum class FrameStatus : std::uint8_t {
  frame,   // there it is
  failed,  // this one could not be had, name, sequence and error say why; go on with the next
  end,     // there are no more
};

class FrameSource {
 public:
  virtual ~FrameSource() = default;
  [[nodiscard]] virtual FrameStatus next(CapturedFrame& frame) = 0;
};

}  // namespace aspect
