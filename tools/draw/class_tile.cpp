#include "tools/draw/class_tile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

#include "runtime/service/recognition_json.h"
#include "tools/draw/model_picture.h"
#include "tools/draw/picture_text.h"

namespace aspect {
namespace {

constexpr double kFar_px = 1e5;  // an index may say anything

// Where a key view's outline is in a picture.
struct Outline {
  cv::Point2d centre;
  double unit_px = 1;  // the square root of its area
};

const KeyView* shown_key_view(const ClassIndex& index, const AspectClass& aspect) {
  const KeyView* nearest = nullptr;
  float most = -2;
  for (const KeyView& view : ClassIndex::part(index.key_views, aspect.key_views)) {
    const float cosine = view.direction[0] * aspect.view[0] + view.direction[1] * aspect.view[1] +
                         view.direction[2] * aspect.view[2];
    if (cosine <= most) continue;
    most = cosine;
    nearest = &view;
  }
  return nearest;
}

std::span<const KeyContour> contours_of(const ClassIndex& index, const AspectClass& aspect) {
  const KeyView* view = shown_key_view(index, aspect);
  if (view == nullptr) return {};
  return ClassIndex::part(index.key_contours, view->contours);
}

Outline outline_in(const cv::Mat& covered) {
  const cv::Moments moments = cv::moments(covered, true);
  if (!(moments.m00 > 0)) return {};
  return {{moments.m10 / moments.m00, moments.m01 / moments.m00}, std::sqrt(moments.m00)};
}

cv::Point at(const Outline& outline, Point2 position) {
  const auto within = [](double pixel) { return cvRound(std::clamp(pixel, -kFar_px, kFar_px)); };
  return {within(outline.centre.x + outline.unit_px * static_cast<double>(position.x)),
          within(outline.centre.y + outline.unit_px * static_cast<double>(position.y))};
}

// Where a label is best read as that of a contour: its centre or, where that lies beside it, as of
// a ring, the nearest place in its colour that is wide enough, or is at all.
cv::Point label_place(const cv::Mat& picture, const cv::Mat& covered, const KeyContour& contour,
                      cv::Point centre) {
  constexpr float kAlike = 0.03F;  // shares are means over views
  cv::Mat alike = cv::Mat::zeros(picture.size(), CV_8UC1);
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x) {
      if (covered.at<std::uint8_t>(y, x) == 0) continue;
      const auto& bgr = picture.at<cv::Vec3b>(y, x);
      const float sum = static_cast<float>(std::max(1, bgr[0] + bgr[1] + bgr[2]));
      bool is_alike = true;
      for (std::size_t k = 0; k < 3; ++k)
        is_alike = is_alike && std::abs(static_cast<float>(bgr[2 - static_cast<int>(k)]) / sum -
                                        contour.feature.share[k]) <= kAlike;
      alike.at<std::uint8_t>(y, x) = is_alike ? 255 : 0;
    }
  cv::Mat wide;
  cv::erode(alike, wide, cv::Mat::ones(5, 5, CV_8UC1));
  for (const cv::Mat& places : {wide, alike}) {
    std::vector<cv::Point> points;
    cv::findNonZero(places, points);
    const auto nearest =
        std::min_element(points.begin(), points.end(), [&](cv::Point a, cv::Point b) {
          return (a - centre).ddot(a - centre) < (b - centre).ddot(b - centre);
        });
    if (nearest != points.end()) return *nearest;
  }
  return centre;
}

// There, or on a ring about it where another label is.
void draw_label(LabelPlacer& labels, const std::string& name, cv::Point place,
                const TextStyle& style) {
  const cv::Size size = text_size(name, style);
  const cv::Point corner = place - cv::Point(size.width / 2, size.height / 2);
  std::vector<cv::Point> corners = {corner};
  for (const double reach : {0.75, 1.5})
    for (int k = 0; k < 8; ++k)
      corners.push_back(corner + cv::Point(cvRound(reach * size.width * std::cos(k * CV_PI / 4)),
                                           cvRound(reach * size.height * std::sin(k * CV_PI / 4))));
  labels.draw(name, corners, style, {255, 255, 255});
}

cv::Scalar shown_colour(const std::array<float, 3>& share) {
  const float most = std::max({share[0], share[1], share[2], 1e-6F});
  return {230.0 * static_cast<double>(share[2] / most),
          230.0 * static_cast<double>(share[1] / most),
          230.0 * static_cast<double>(share[0] / most)};
}

// As wide along its axes as a filled ellipse of these moments is.
void draw_ellipse(cv::Mat& picture, const Outline& outline, const ContourFeature& feature) {
  const double area =
      std::max(0.0, static_cast<double>(feature.area)) * outline.unit_px * outline.unit_px;
  const cv::Matx22d spread(
      static_cast<double>(feature.moments.xx), static_cast<double>(feature.moments.xy),
      static_cast<double>(feature.moments.xy), static_cast<double>(feature.moments.yy));
  cv::Mat values, vectors;
  cv::eigen(cv::Mat(spread), values, vectors);
  const auto axis_px = [&](int k) {
    const double px = 2 * std::sqrt(std::max(0.0, values.at<double>(k) * area));
    return cvRound(std::clamp(px, 1.0, 2.0 * picture.cols));
  };
  const double angle_deg =
      std::atan2(vectors.at<double>(0, 1), vectors.at<double>(0, 0)) * 180 / CV_PI;
  const cv::Size axes(axis_px(0), axis_px(1));
  const cv::Point centre = at(outline, feature.position);
  cv::ellipse(picture, centre, axes, angle_deg, 0, 360, shown_colour(feature.share), cv::FILLED,
              cv::LINE_AA);
  cv::ellipse(picture, centre, axes, angle_deg, 0, 360, {52, 46, 42}, 1, cv::LINE_AA);
}

// The largest first, so that what lies on others is seen.
void draw_ellipses(cv::Mat& picture, const Outline& outline, std::span<const KeyContour> contours) {
  std::vector<const KeyContour*> by_size;
  for (const KeyContour& contour : contours) by_size.push_back(&contour);
  std::stable_sort(by_size.begin(), by_size.end(),
                   [](const auto* a, const auto* b) { return a->feature.area > b->feature.area; });
  for (const KeyContour* contour : by_size) draw_ellipse(picture, outline, contour->feature);
}

}  // namespace

Vector3d shown_view(const ClassIndex& index, const AspectClass& aspect) {
  const KeyView* view = shown_key_view(index, aspect);
  const Vector3& v = view != nullptr ? view->direction : aspect.view;
  const Vector3d direction{static_cast<double>(v[0]), static_cast<double>(v[1]),
                           static_cast<double>(v[2])};
  const double length = norm(direction);
  return length > 0 ? (1 / length) * direction : Vector3d{0, 0, 1};
}

cv::Mat class_tile(const ClassIndex& index, const AspectClass& aspect, int side_px) {
  const auto contours = contours_of(index, aspect);
  ModelPicture drawn = model_picture(index.model, shown_view(index, aspect),
                                     static_cast<double>(index.field_of_view_deg), side_px);
  Outline outline = outline_in(drawn.covered);
  if (index.model.empty()) {
    outline = {{side_px / 2.0, side_px / 2.0}, 0.5 * side_px};
    draw_ellipses(drawn.picture, outline, contours);
  }
  const cv::Mat flat = drawn.picture.clone();
  LabelPlacer labels(drawn.picture);
  for (const KeyContour& contour : contours) {
    std::array<char, 4> buffer;
    draw_label(labels, std::string(contour_name(contour.name, buffer)),
               label_place(flat, drawn.covered, contour, at(outline, contour.feature.position)),
               text_style_for(flat.size()));
  }
  return drawn.picture;
}

}  // namespace aspect
