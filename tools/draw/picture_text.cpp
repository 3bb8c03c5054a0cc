#include "tools/draw/picture_text.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace aspect {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kCapital_px = 21;  // height of a capital at scale 1
constexpr int kLeastCapital_px = 9;

TextStyle style_of(double capital_px) {
  TextStyle style;
  style.scale = capital_px / kCapital_px;
  style.thickness_px = std::max(1, cvRound(capital_px / 11));
  style.line_px = cvRound(capital_px * 1.9);
  return style;
}

std::string printable(const std::string& text) {
  std::string clean;
  for (const char c : text) {
    // Of a character of several bytes only the first one counts.
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 && byte < 0xC0) continue;
    clean += byte >= 0x20 && byte < 0x7F ? c : '?';
  }
  return clean;
}

int outline_px(const TextStyle& style) {
  return style.thickness_px + 1;
}

// Null: without an outline.
void put(cv::Mat& picture, const std::string& text, cv::Point corner, const TextStyle& style,
         const cv::Scalar& colour, const cv::Scalar* outline) {
  const cv::Size size = text_size(text, style);
  const int x = std::max(0, std::min(corner.x, picture.cols - size.width));
  const int y = std::max(0, std::min(corner.y, picture.rows - size.height));
  const std::string clean = printable(text);
  int below_px = 0;
  const int above_px =
      cv::getTextSize(clean, kFont, style.scale, style.thickness_px, &below_px).height;
  const cv::Point base(x + outline_px(style), y + outline_px(style) + above_px);
  if (outline != nullptr)
    cv::putText(picture, clean, base, kFont, style.scale, *outline,
                style.thickness_px + 2 * outline_px(style), cv::LINE_AA);
  cv::putText(picture, clean, base, kFont, style.scale, colour, style.thickness_px, cv::LINE_AA);
}

}  // namespace

TextStyle text_style_for(cv::Size picture) {
  return style_of(std::max(kLeastCapital_px, std::min(picture.width, picture.height) / 45));
}

TextStyle fitted(const TextStyle& style, const std::string& text, int width_px) {
  const int needed_px = text_size(text, style).width;
  if (needed_px <= width_px) return style;
  const double shrink = std::max(0.5, static_cast<double>(width_px) / needed_px);
  return style_of(style.scale * kCapital_px * shrink);
}

cv::Size text_size(const std::string& text, const TextStyle& style) {
  int below_px = 0;
  const cv::Size size =
      cv::getTextSize(printable(text), kFont, style.scale, style.thickness_px, &below_px);
  const int rim = 2 * outline_px(style);
  return {size.width + rim, size.height + below_px + rim};
}

void draw_text(cv::Mat& picture, const std::string& text, cv::Point corner, const TextStyle& style,
               const cv::Scalar& colour) {
  const cv::Scalar dark(20, 20, 20);
  put(picture, text, corner, style, colour, &dark);
}

void draw_dark_text(cv::Mat& picture, const std::string& text, cv::Point corner,
                    const TextStyle& style, const cv::Scalar& colour) {
  put(picture, text, corner, style, colour, nullptr);
}

cv::Rect LabelPlacer::within_picture(cv::Point corner, cv::Size size) const {
  return {std::max(0, std::min(corner.x, picture_.cols - size.width)),
          std::max(0, std::min(corner.y, picture_.rows - size.height)), size.width, size.height};
}

bool LabelPlacer::is_free(const cv::Rect& place) const {
  return std::none_of(taken_.begin(), taken_.end(),
                      [&](const cv::Rect& other) { return (other & place).area() > 0; });
}

void LabelPlacer::draw(const std::string& text, std::span<const cv::Point> corners,
                       const TextStyle& style, const cv::Scalar& colour) {
  constexpr int kMaxMoves = 12;
  const cv::Size size = text_size(text, style);
  std::vector<cv::Rect> places;
  for (const cv::Point corner : corners) places.push_back(within_picture(corner, size));
  for (int move = 1; move <= kMaxMoves; ++move)
    places.push_back(within_picture(corners.front() + cv::Point(0, move * size.height / 2), size));
  const auto found = std::find_if(places.begin(), places.end(),
                                  [&](const cv::Rect& place) { return is_free(place); });
  const cv::Rect place = found == places.end() ? places.front() : *found;
  taken_.push_back(place);
  draw_text(picture_, text, place.tl(), style, colour);
}

void LabelPlacer::draw_centred(const std::string& text, cv::Point centre, const TextStyle& style,
                               const cv::Scalar& colour) {
  const cv::Size size = text_size(text, style);
  const cv::Point corner = centre - cv::Point(size.width / 2, size.height / 2);
  draw(text, std::span(&corner, 1), style, colour);
}

}  // namespace aspect
