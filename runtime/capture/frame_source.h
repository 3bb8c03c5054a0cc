// Where frames come from: a camera, recorded files, test patterns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/vision/frame.h"

namespace aspect {

// Of a frame without gaps between its rows and planes.
constexpr std::size_t frame_bytes(PixelFormat format, int width_px, int height_px) {
  const std::size_t pixels =
      static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
  return pixels * static_cast<std::size_t>(bytes_per_pixel(format)) +
         (has_chroma_plane(format) ? pixels / 2 : 0);
}

// A frame with the memory that it is in; reused from frame to frame it stops allocating.
struct CapturedFrame {
  std::string name;            // of the file, the video with the frame's number, or the camera
  std::uint64_t sequence = 0;  // place among all frames of the source, lost ones counted
  int width_px = 0, height_px = 0;
  PixelFormat format = PixelFormat::bgr8;
  std::vector<std::uint8_t> pixels;  // row by row without gaps; then the chroma plane likewise
  std::string error;                 // one line that names the file; only of a failed frame

  Frame view() const {
    Frame frame{pixels.data(), width_px, height_px,
                std::ptrdiff_t{bytes_per_pixel(format)} * width_px, format};
    if (has_chroma_plane(format)) {
      frame.chroma = pixels.data() + std::ptrdiff_t{width_px} * height_px;
      frame.chroma_stride_bytes = width_px;
    }
    return frame;
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
