#include "runtime/capture/video_file.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <exception>

#include "runtime/capture/decoders.h"
#include "runtime/capture/mat_frame.h"
#include "runtime/capture/picture_header.h"
#include "runtime/capture/stderr_capture.h"

namespace aspect {
namespace {

// Frames that may be missing against what the container announces before it counts as cut off: for
// some containers the number is the duration times the rate, rounded.
double tolerated_missing(double announced) {
  return std::max(2.0, 0.02 * announced);
}

}  // namespace

FrameStatus VideoFile::next(CapturedFrame& frame) {
  if (ended_) return FrameStatus::end;
  if (!opened_ && !open(frame)) return FrameStatus::failed;
  frame.name = fmt::format("{}#{}", file_.native(), frames_);
  cv::Mat picture;
  try {
    StderrCapture silence;
    if (!capture_.read(picture)) picture.release();
  } catch (const std::exception&) {
    picture.release();
  }
  if (picture.empty()) return end(frame);
  if (picture.type() != CV_8UC3) return fail(frame, "its frames are not in colour; convert it");
  if (const auto fault = size_fault(picture.cols, picture.rows)) return fail(frame, *fault);
  copy_picture(picture, PixelFormat::bgr8, frame);
  ++frames_;
  return FrameStatus::frame;
}

bool VideoFile::open(CapturedFrame& frame) {
  opened_ = true;
  frame.name = file_.native();
  // Absolute, so that no name can be taken for a protocol. These two readers only: others would
  // take a name with digits for a numbered series of pictures, or a text for a pipeline.
  const std::string path = std::filesystem::absolute(file_).native();
  for (const int reader : {cv::CAP_FFMPEG, cv::CAP_OPENCV_MJPEG}) {
    try {
      StderrCapture silence;
      if (capture_.open(path, reader)) break;
    } catch (const std::exception&) {
      continue;
    }
  }
  if (!capture_.isOpened()) {
    fail(frame, "not a video that can be read; convert it, for example to MJPEG in AVI");
    return false;
  }
  const double width = capture_.get(cv::CAP_PROP_FRAME_WIDTH);
  const double height = capture_.get(cv::CAP_PROP_FRAME_HEIGHT);
  const auto fault = size_fault(std::lround(width), std::lround(height));
  if (fault) fail(frame, *fault);
  return !fault;
}

FrameStatus VideoFile::fail(CapturedFrame& frame, const std::string& what) {
  ended_ = true;
  frame.error = file_.native() + ": " + what;
  return FrameStatus::failed;
}

FrameStatus VideoFile::end(CapturedFrame& frame) {
  const double announced = capture_.get(cv::CAP_PROP_FRAME_COUNT);
  const auto read = static_cast<double>(frames_);
  if (frames_ == 0) return fail(frame, "a video without frames; record it again");
  if (announced - read > tolerated_missing(announced))
    return fail(frame, fmt::format("ends after {} of {:.0f} frames; it is cut off or damaged, "
                                   "copy or record it again",
                                   frames_, announced));
  ended_ = true;
  return FrameStatus::end;
}

std::unique_ptr<FrameSource> open_video(const std::filesystem::path& file) {
  return std::make_unique<VideoFile>(file);
}

}  // namespace aspect
