#include "tools/draw/frame_canvas.h"

#include <algorithm>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "runtime/vision/contour_trace.h"
#include "runtime/workbench/frame_picture.h"
#include "tools/draw/id_colour.h"

namespace aspect {
namespace {

constexpr int kReadableSide_px = 400;
constexpr int kMaxScale = 8;

int scale_for(cv::Size frame) {
  const int side = std::max(1, std::min(frame.width, frame.height));
  return std::clamp((kReadableSide_px + side - 1) / side, 1, kMaxScale);
}

cv::Mat depths_as_greys(const cv::Mat& depths) {
  constexpr double kNearest = 255, kFarthest = 64;
  const cv::Mat measured = (depths > 0) & (depths < 65535);
  double least = 0, most = 0;
  cv::minMaxLoc(depths, &least, &most, nullptr, nullptr, measured);
  const double scale = most > least ? (kFarthest - kNearest) / (most - least) : 0;
  cv::Mat greys, picture = cv::Mat::zeros(depths.size(), CV_8UC1);
  depths.convertTo(greys, CV_8UC1, scale, kNearest - scale * least);
  greys.copyTo(picture, measured);
  return picture;
}

cv::Mat ids_as_colours(const cv::Mat& ids) {
  cv::Mat picture = cv::Mat::zeros(ids.size(), CV_8UC3);
  for (int y = 0; y < ids.rows; ++y)
    for (int x = 0; x < ids.cols; ++x)
      if (const int id = ids.at<std::uint16_t>(y, x); id != 0) {
        const cv::Scalar colour = id_colour(id);
        picture.at<cv::Vec3b>(y, x) = cv::Vec3b(cv::saturate_cast<std::uint8_t>(colour[0]),
                                                cv::saturate_cast<std::uint8_t>(colour[1]),
                                                cv::saturate_cast<std::uint8_t>(colour[2]));
      }
  return picture;
}

cv::Mat camera_colours(const Frame& frame) {
  cv::Mat picture(frame.height_px, frame.width_px, CV_8UC3);
  for (int y = 0; y < frame.height_px; ++y)
    for (int x = 0; x < frame.width_px; ++x) {
      const auto [red, green, blue] = preview_rgb(frame, x, y);
      picture.at<cv::Vec3b>(y, x) = cv::Vec3b(blue, green, red);
    }
  return picture;
}

}  // namespace

cv::Mat recorded_picture(const Frame& frame) {
  const int channels = bytes_per_pixel(frame.format);
  const int type = channels == 2 ? CV_16UC1 : CV_8UC(channels);
  // OpenCV has no read-only view; the copy below is what gets drawn on.
  const cv::Mat view(frame.height_px, frame.width_px, type, const_cast<std::uint8_t*>(frame.data),
                     static_cast<std::size_t>(frame.stride_bytes));
  cv::Mat picture;
  if (frame.format == PixelFormat::rgb8)
    cv::cvtColor(view, picture, cv::COLOR_RGB2BGR);
  else if (channels == 4)
    cv::cvtColor(view, picture,
                 frame.format == PixelFormat::rgbx8 ? cv::COLOR_RGBA2BGR : cv::COLOR_BGRA2BGR);
  else
    view.copyTo(picture);
  return picture;
}

cv::Mat picture_of(const Frame& frame) {
  if (is_yuv(frame.format) || is_bayer(frame.format)) return camera_colours(frame);
  cv::Mat picture = recorded_picture(frame);
  if (picture.type() == CV_16UC1)
    picture =
        frame.format == PixelFormat::label16 ? ids_as_colours(picture) : depths_as_greys(picture);
  if (picture.channels() == 1) cv::cvtColor(picture, picture, cv::COLOR_GRAY2BGR);
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
