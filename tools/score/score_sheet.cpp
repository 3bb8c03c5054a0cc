#include "tools/score/score_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tools/draw/contact_sheet.h"
#include "tools/replay/stage_pictures.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

// Wide enough to read the overlay's own words.
constexpr int kCellWidth_px = 420;
constexpr int kMostColumns = 5;

cv::Mat cell_picture(const cv::Mat& overlay) {
  const double scale = static_cast<double>(kCellWidth_px) / overlay.cols;
  cv::Mat small;
  cv::resize(overlay, small, {}, scale, scale, cv::INTER_AREA);
  return small;
}

std::string part_of_caption(const ScoredObject& object) {
  if (object.right) return fmt::format("{} ({:.1f})", object.found, object.error_deg);
  if (object.truth.empty()) return object.found + " (nothing known there)";
  return fmt::format("{} (is {})", object.found.empty() ? "nothing" : object.found, object.truth);
}

}  // namespace

std::string frame_caption(const ScoredFrame& frame) {
  std::string caption = fs::path(frame.file).stem().native() + ":";
  if (frame.line == nullptr) return caption + " missing";
  if (frame.objects.empty()) return caption + " nothing";
  for (std::size_t k = 0; k < frame.objects.size(); ++k)
    caption += (k == 0 ? " " : ", ") + part_of_caption(frame.objects[k]);
  return caption;
}

std::optional<Error> write_score_sheet(const Score& score, const fs::path& overlays,
                                       const fs::path& sheet) {
  std::vector<SheetPicture> pictures;
  for (const ScoredFrame& frame : score.frames) {
    cv::Mat picture;
    if (frame.line != nullptr) {
      CapturedFrame captured;
      captured.name = frame.line->frame;
      captured.sequence = frame.line->sequence;
      const fs::path file = overlays / (overlay_name(captured) + ".png");
      picture = cv::imread(file.native());
      if (picture.empty())
        return Error{file.native() +
                     ": no such picture; run aspect-replay with --overlay on the same frames"};
      picture = cell_picture(picture);
    }
    pictures.push_back({picture, frame_caption(frame)});
  }
  const int columns =
      std::clamp(static_cast<int>(std::ceil(std::sqrt(static_cast<double>(pictures.size())))), 1,
                 kMostColumns);
  try {
    if (cv::imwrite(sheet.native(), contact_sheet(pictures, columns))) return std::nullopt;
  } catch (const cv::Exception&) {
    // Said below: OpenCV's own words name neither the file nor the way out.
  }
  return Error{sheet.native() + ": cannot be written; give a .png in a folder that exists"};
}

}  // namespace aspect
