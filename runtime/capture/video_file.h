// The frames of a video file, one after the other.
#pragma once

#include <cstddef>
#include <filesystem>
#include <opencv2/videoio.hpp>

#include "runtime/capture/frame_source.h"

namespace aspect {

class VideoFile : public FrameSource {
 public:
  explicit VideoFile(std::filesystem::path file) : file_(std::move(file)) {}

  // Fills in name, size, pixels or the error. After a failed frame only the end follows.
  [[nodiscard]] FrameStatus next(CapturedFrame& frame) override;

 private:
  bool open(CapturedFrame& frame);
  FrameStatus fail(CapturedFrame& frame, const std::string& what);
  FrameStatus end(CapturedFrame& frame);

  std::filesystem::path file_;
  cv::VideoCapture capture_;
  std::size_t frames_ = 0;
  bool opened_ = false, ended_ = false;
};

}  // namespace aspect
