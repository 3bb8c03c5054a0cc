#include <cstdlib>
#include <opencv2/core/utils/logger.hpp>

#include "runtime/capture/decoders.h"

namespace aspect {

void silence_decoders() {
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  // FFmpeg's threads log whenever they like; -8 is its AV_LOG_QUIET. A user's own choice stays.
  setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
}

}  // namespace aspect
