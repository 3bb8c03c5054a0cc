// Light text with a dark outline, readable on whatever is behind it.
#pragma once

#include <opencv2/core.hpp>
#include <span>
#include <string>
#include <vector>

#include "tools/draw/paper.h"

namespace aspect {

struct TextStyle {
  double scale = 0.5;  // of OpenCV's plain Hershey font
  int thickness_px = 1;
  int line_px = 20;  // from one line to the next
};

// A thirtieth of the picture's shorter side, but never too small to read.
TextStyle text_style_for(cv::Size picture);
// The same style, smaller where the text would be wider than it may; down to half its size.
TextStyle fitted(const TextStyle& style, const std::string& text, int width_px);
cv::Size text_size(const std::string& text, const TextStyle& style);

// `corner` is the text's upper left one; moved so that the text stays in the picture if it can.
// What the font does not have becomes a question mark.
void draw_text(cv::Mat& picture, const std::string& text, cv::Point corner, const TextStyle& style,
               const cv::Scalar& colour = {255, 255, 255});

// Dark text without an outline, for light paper; otherwise the same.
void draw_dark_text(cv::Mat& picture, const std::string& text, cv::Point corner,
                    const TextStyle& style, const cv::Scalar& colour = kInk);

// Texts that keep out of each other's way.
class LabelPlacer {
 public:
  explicit LabelPlacer(cv::Mat& picture) : picture_(picture) {}
  // At the first of the corners where no other text is; if there is none, further down.
  void draw(const std::string& text, std::span<const cv::Point> corners, const TextStyle& style,
            const cv::Scalar& colour);
  void draw_centred(const std::string& text, cv::Point centre, const TextStyle& style,
                    const cv::Scalar& colour);

 private:
  cv::Rect within_picture(cv::Point corner, cv::Size size) const;
  bool is_free(const cv::Rect& place) const;

  cv::Mat& picture_;
  std::vector<cv::Rect> taken_;
};

}  // namespace aspect
