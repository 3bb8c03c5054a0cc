#include <cstdlib>
#include <opencv2/core/utils/logger.hpp>

#include "runtime/capture/decoders.h"
#include "runtime/capture/video_file.h"

namespace aspect {

void silence_decoders() {
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  // FFmpeg's threads log whenever they like; -8 is its AV_LOG_QUIET. A user's own choice stays.
  setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
}

std::unique_ptr<FrameSource> open_video(const std::filesystem::path& file) {
  return std::make_unique<VideoFile>(file);
}

}  // namespace aspect
