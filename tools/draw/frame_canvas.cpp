#include "tools/draw/frame_canvas.h"

#include <algorithm>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "runtime/vision/contour_trace.h"

namespace aspect {
namespace {

constexpr int kReadableSide_px = 400;
constexpr int kMaxScale = 8;

int scale_for(cv::Size frame) {
  const int side = std::max(1, std::min(frame.width, frame.height));
  return std::clamp((kReadableSide_px + side - 1) / side, 1, kMaxScale);
}

}  // namespace

cv::Mat picture_of(const Frame& frame) {
  // OpenCV has no read-only view; the copy below is what gets drawn on.
  const cv::Mat view(frame.height_px, frame.width_px, CV_8UC3,
                     const_cast<std::uint8_t*>(frame.data),
                     static_cast<std::size_t>(frame.stride_bytes));
  cv::Mat picture;
  if (frame.format == PixelFormat::bgr8)
    view.copyTo(picture);
  else
    cv::cvtColor(view, picture, cv::COLOR_RGB2BGR);
  return picture;
}

FrameCanvas::FrameCanvas(const cv::Mat& frame_picture) : scale_(scale_for(frame_picture.size())) {
  cv::resize(frame_picture, picture_, {}, scale_, scale_, cv::INTER_NEAREST);
}

cv::Point FrameCanvas::at(float x, float y) const {
  const auto scale = static_cast<float>(scale_);
  return {cvRound(x * scale + (scale - 1) / 2), cvRound(y * scale + (scale - 1) / 2)};
}

cv::Rect FrameCanvas::at(const Box& box) const {
  return {box.x * scale_, box.y * scale_, box.width * scale_, box.height * scale_};
}

int FrameCanvas::line_px() const {
  return std::max(1, std::min(picture_.cols, picture_.rows) / 400);
}

void FrameCanvas::draw_outline(const Contour& contour, const cv::Scalar& colour) {
  std::vector<cv::Point> points;
  points.reserve(contour.chain.size() + 1);
  int x = contour.start_x, y = contour.start_y;
  points.push_back(at(static_cast<float>(x), static_cast<float>(y)));
  for (const std::uint8_t code : contour.chain) {
    x += kStepX[code];
    y += kStepY[code];
    points.push_back(at(static_cast<float>(x), static_cast<float>(y)));
  }
  cv::polylines(picture_, points, true, colour, line_px());
}

Point2 label_point(const Contour& contour, const RegionMap& map) {
  if (!contour.external) return contour.centre_px;
  Point2 nearest = contour.centre_px;
  float least = std::numeric_limits<float>::infinity();
  for (const Run& run : map.runs) {
    if (run.label != contour.region) continue;
    const Point2 point = {std::clamp(contour.centre_px.x, static_cast<float>(run.begin),
                                     static_cast<float>(run.end - 1)),
                          static_cast<float>(run.row)};
    const float dx = point.x - contour.centre_px.x, dy = point.y - contour.centre_px.y;
    if (dx * dx + dy * dy >= least) continue;
    least = dx * dx + dy * dy;
    nearest = point;
  }
  return nearest;
}

}  // namespace aspect
