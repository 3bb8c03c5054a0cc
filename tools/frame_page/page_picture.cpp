#include "tools/frame_page/page_picture.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "tools/draw/frame_canvas.h"

namespace aspect {
namespace {

std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr const char* kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const auto at = [&](std::size_t i) { return i < bytes.size() ? bytes[i] : 0U; };
    const unsigned three = at(k) << 16U | at(k + 1) << 8U | at(k + 2);
    for (std::size_t digit = 0; digit < 4; ++digit)
      text += k + digit > bytes.size() ? '=' : kLetters[three >> (18 - 6 * digit) & 63U];
  }
  return text;
}

cv::Mat scaled_down(const cv::Mat& picture, int side_px) {
  const int longest = std::max(picture.cols, picture.rows);
  if (longest <= side_px) return picture;
  const double scale = static_cast<double>(side_px) / longest;
  cv::Mat smaller;
  cv::resize(
      picture, smaller,
      {std::max(1, cvRound(picture.cols * scale)), std::max(1, cvRound(picture.rows * scale))}, 0,
      0, cv::INTER_AREA);
  return smaller;
}

}  // namespace

std::string picture_uri(const Frame& frame) {
  struct Try {
    int side_px, quality;
  };
  constexpr std::array<Try, 3> kTries = {
      {{kMostPagePictureSide_px, 80}, {kMostPagePictureSide_px, 50}, {480, 40}}};
  const cv::Mat picture = picture_of(frame);
  std::vector<std::uint8_t> bytes;
  for (const Try& settings : kTries) {
    cv::imencode(".webp", scaled_down(picture, settings.side_px), bytes,
                 {cv::IMWRITE_WEBP_QUALITY, settings.quality});
    if (bytes.size() <= kMostPagePictureBytes) break;
  }
  return "data:image/webp;base64," + base64(bytes);
}

}  // namespace aspect
