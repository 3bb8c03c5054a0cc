#include "tools/calibrate/colours/sample_draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "tools/draw/id_colour.h"
#include "tools/draw/picture_text.h"

namespace aspect {
namespace {

constexpr int kSwatch_px = 56, kBar_px = 44;

// Blue first, as light as can be.
cv::Scalar swatch_colour(const Eigen::Vector3d& share) {
  const Eigen::Vector3d full = share / std::max(share.maxCoeff(), 1e-9) * 230;
  return {full[2], full[1], full[0]};
}

void hatch(cv::Mat& drawn, const PaintSample& sample) {
  const cv::Scalar colour = id_colour(sample.paint);
  cv::Mat mask(drawn.size(), CV_8U, cv::Scalar(0));
  for (const cv::Point& p : sample.pixels) {
    mask.at<std::uint8_t>(p) = 255;
    if ((p.x + p.y) % 6 == 0)
      drawn.at<cv::Vec3b>(p) = {static_cast<std::uint8_t>(colour[0]),
                                static_cast<std::uint8_t>(colour[1]),
                                static_cast<std::uint8_t>(colour[2])};
  }
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(mask, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  cv::drawContours(drawn, outlines, -1, colour, 1);
}

}  // namespace

cv::Mat draw_samples(const cv::Mat& picture, const cv::Mat& map, const std::vector<Paint>& paints,
                     const std::vector<PaintSample>& samples, const std::string& caption) {
  cv::Mat drawn;
  cv::copyMakeBorder(picture, drawn, 0, kBar_px, 0, 0, cv::BORDER_CONSTANT, {24, 24, 24});
  cv::Mat frame = drawn.rowRange(0, picture.rows);
  if (!map.empty()) {
    cv::Mat borders;
    cv::compare(distance_to_border(map), 0.5, borders, cv::CMP_LT);
    frame.setTo(cv::Scalar(255, 255, 255), borders);
  }
  for (const PaintSample& sample : samples) hatch(frame, sample);
  int x = 8;
  for (std::size_t p = 0; p < paints.size(); ++p) {
    const int y = picture.rows + 6;
    const auto seen = std::find_if(samples.begin(), samples.end(), [&](const PaintSample& sample) {
      return sample.paint == static_cast<int>(p);
    });
    if (seen == samples.end()) continue;
    cv::rectangle(drawn, {x, y, kSwatch_px / 2, kBar_px - 16},
                  swatch_colour(shares_of(paints[p].shown)), cv::FILLED);
    cv::rectangle(drawn, {x + kSwatch_px / 2, y, kSwatch_px / 2, kBar_px - 16},
                  swatch_colour(seen->share), cv::FILLED);
    cv::rectangle(drawn, {x - 2, y - 2, kSwatch_px + 3, kBar_px - 12},
                  id_colour(static_cast<int>(p)), 2);
    x += kSwatch_px + 8;
  }
  draw_text(frame, caption, {8, 8}, fitted(text_style_for(frame.size()), caption, frame.cols - 16));
  return drawn;
}

}  // namespace aspect
