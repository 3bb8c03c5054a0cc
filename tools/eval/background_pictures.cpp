#include "tools/eval/background_pictures.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <system_error>

#include "runtime/capture/decoders.h"
#include "runtime/capture/recorded_files.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> at_even_steps(const std::vector<fs::path>& files, std::size_t most) {
  if (files.size() <= most) return files;
  std::vector<fs::path> some;
  for (std::size_t k = 0; k < most; ++k) some.push_back(files[k * files.size() / most]);
  return some;
}

cv::Mat rgb_of(CapturedFrame& frame, int longest_px) {
  const cv::Mat bgr(frame.height_px, frame.width_px, CV_8UC3, frame.pixels.data());
  cv::Mat rgb;
  cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
  const double times = static_cast<double>(longest_px) / std::max(rgb.cols, rgb.rows);
  if (times >= 1) return rgb;
  const cv::Size size(std::max(1, cvRound(rgb.cols * times)),
                      std::max(1, cvRound(rgb.rows * times)));
  cv::resize(rgb, rgb, size, 0, 0, cv::INTER_AREA);
  return rgb;
}

}  // namespace

Result<BackgroundPictures> read_backgrounds(const fs::path& folder, int longest_px) {
  const std::string& name = folder.native();
  std::error_code code;
  if (!fs::exists(folder, code)) return Error{name + ": no such folder; check the path"};
  if (!fs::is_directory(folder, code))
    return Error{name + ": not a folder; give a folder of pictures"};
  const Result<std::vector<fs::path>> files = frame_files_in(folder);
  if (!files) return Error{files.error()};
  BackgroundPictures pictures{name, files.value().size(), {}};
  silence_decoders();
  CapturedFrame frame;
  for (const fs::path& file : at_even_steps(files.value(), kMostBackgrounds)) {
    if (recorded_kind(file) == RecordedKind::raw)
      return Error{file.native() + ": raw frames; give pictures (.png, .jpg, .ppm and the like)"};
    if (!read_picture(file, SensorKind::colour, frame)) return Error{frame.error};
    pictures.rgb.push_back(rgb_of(frame, longest_px));
  }
  return pictures;
}

}  // namespace aspect
