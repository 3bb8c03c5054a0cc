#include "tools/doctor/finding_badges.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tools/draw/paper.h"
#include "tools/draw/picture_text.h"

namespace aspect {
namespace {

constexpr int kBadge_px = 13;  // radius

// How far a point is from the way to a badge.
double distance(cv::Point2d p, cv::Point2d from, cv::Point2d to) {
  const cv::Point2d way = to - from;
  const double share = std::clamp((p - from).dot(way) / std::max(1.0, way.dot(way)), 0.0, 1.0);
  return cv::norm(p - from - share * way);
}

}  // namespace

void draw_badge(cv::Mat& picture, cv::Point centre, const std::string& label,
                const cv::Scalar& colour) {
  const TextStyle style = text_style_for({450, 450});
  const int half = std::max(kBadge_px, text_size(label, style).width / 2 + 1);
  const auto pill = [&](int grow, const cv::Scalar& ink) {
    const int r = kBadge_px + grow;
    cv::line(picture, centre - cv::Point(half - kBadge_px, 0),
             centre + cv::Point(half - kBadge_px, 0), ink, 2 * r, cv::LINE_AA);
  };
  pill(2, {255, 255, 255});
  pill(0, colour);
  const cv::Size size = text_size(label, style);
  draw_dark_text(picture, label, centre - cv::Point(size.width / 2, size.height / 2 - 1), style,
                 {255, 255, 255});
}

void Badges::add(cv::Point at, const std::string& label, const cv::Scalar& colour) {
  const cv::Point centre = place(at);
  taken_.push_back({at, centre});
  cv::line(picture_, at, centre, {255, 255, 255}, 4, cv::LINE_AA);
  cv::line(picture_, at, centre, kInk, 2, cv::LINE_AA);
  cv::circle(picture_, at, 3, kInk, cv::FILLED, cv::LINE_AA);
  draw_badge(picture_, centre, label, colour);
}

cv::Point Badges::place(cv::Point at) const {
  const double outwards = std::atan2(at.y - picture_.rows / 2.0, at.x - picture_.cols / 2.0 + 1e-9);
  for (const double reach_px : {40.0, 64.0, 92.0, 124.0})
    for (const int turn : {0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 6}) {
      const double angle = outwards + turn * CV_PI / 6;
      const cv::Point centre =
          at + cv::Point(cvRound(reach_px * std::cos(angle)), cvRound(reach_px * std::sin(angle)));
      if (is_free(at, centre)) return centre;
    }
  return {std::clamp(at.x, 2 * kBadge_px, picture_.cols - 2 * kBadge_px),
          std::clamp(at.y, 2 * kBadge_px, picture_.rows - 2 * kBadge_px)};
}

bool Badges::is_free(cv::Point at, cv::Point centre) const {
  constexpr int kApart_px = 2 * kBadge_px + 6;
  const cv::Rect inside(2 * kBadge_px, 2 * kBadge_px, picture_.cols - 4 * kBadge_px,
                        picture_.rows - 4 * kBadge_px);
  return inside.contains(centre) &&
         std::none_of(taken_.begin(), taken_.end(), [&](const Taken& other) {
           return cv::norm(other.centre - centre) < kApart_px ||
                  distance(centre, other.at, other.centre) < kBadge_px + 4 ||
                  distance(other.centre, at, centre) < kBadge_px + 4;
         });
}

}  // namespace aspect
