#include "tools/eval/clutter_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

namespace aspect {
namespace {

constexpr double kFullTurn_rad = 2 * std::numbers::pi;

// The distance of the border of a superellipse of half axes 1 and `aspect` in a direction; an
// exponent of 2 makes an ellipse, a large one a rectangle.
double superellipse(double angle_rad, double aspect, double exponent) {
  const double along = std::pow(std::abs(std::cos(angle_rad)), exponent),
               across = std::pow(std::abs(std::sin(angle_rad)) / aspect, exponent);
  return std::pow(along + across, -1 / exponent);
}

// Distances of the border at equal angles.
std::vector<double> random_border(Dice& dice) {
  constexpr std::size_t kRound = 64;
  const std::size_t kind = dice.below(4);
  if (kind == 0) {  // a polygon
    std::vector<double> border(3 + dice.below(5));
    for (double& distance : border) distance = dice.between(0.5, 1);
    return border;
  }
  std::vector<double> border(kRound);
  const double aspect = dice.between(kind == 1 ? 0.4 : 0.12, kind == 1 ? 1 : 0.6);
  const double bumps = static_cast<double>(2 + dice.below(5)), turn = dice.between(0, 6.3);
  for (std::size_t k = 0; k < kRound; ++k) {
    const double angle_rad = kFullTurn_rad * static_cast<double>(k) / kRound;
    border[k] = kind == 3 ? 1 + 0.3 * std::sin(bumps * angle_rad + turn)
                          : superellipse(angle_rad, aspect, kind == 1 ? 2 : 40);
  }
  return border;
}

std::array<double, 3> random_colour(Dice& dice) {
  const double hue = dice.between(0, 1), saturation = dice.between(0.05, 0.95),
               value = dice.between(50, 240);
  std::array<double, 3> rgb;
  for (std::size_t c = 0; c < 3; ++c) {
    const double turn = std::abs(std::fmod(hue + static_cast<double>(c) / 3, 1.0) - 0.5);
    rgb[c] = value * (1 - saturation * (1 - std::clamp(6 * turn - 1, 0.0, 1.0)));
  }
  return rgb;
}

}  // namespace

ClutterShape random_shape(Dice& dice) {
  const std::vector<double> border = random_border(dice);
  const double farthest = *std::max_element(border.begin(), border.end());
  const double turn = dice.between(0, kFullTurn_rad);
  ClutterShape shape;
  for (std::size_t k = 0; k < border.size(); ++k) {
    const double angle_rad =
        turn + kFullTurn_rad * static_cast<double>(k) / static_cast<double>(border.size());
    shape.outline.emplace_back(border[k] / farthest * std::cos(angle_rad),
                               border[k] / farthest * std::sin(angle_rad));
  }
  return shape;
}

void draw_shape(const ClutterShape& shape, const cv::Point2d& centre_px, double size_px,
                cv::Mat& mask) {
  constexpr int kSubpixelBits = 4;
  std::vector<cv::Point> corners;
  for (const cv::Point2d& corner : shape.outline) {
    const cv::Point2d place = (centre_px + size_px * corner) * (1 << kSubpixelBits);
    corners.emplace_back(cvRound(place.x), cvRound(place.y));
  }
  cv::fillPoly(mask, std::vector{corners}, cv::Scalar(255), cv::LINE_8, kSubpixelBits);
}

cv::Mat random_piece(const cv::Mat& picture, const cv::Size& size, Dice& dice) {
  const double most = std::min(static_cast<double>(picture.cols) / size.width,
                               static_cast<double>(picture.rows) / size.height);
  const double times = most * dice.between(0.5, 1);
  const int width = std::clamp(cvRound(times * size.width), 1, picture.cols),
            height = std::clamp(cvRound(times * size.height), 1, picture.rows);
  const auto left =
      static_cast<int>(dice.below(static_cast<std::size_t>(picture.cols - width + 1)));
  const auto top =
      static_cast<int>(dice.below(static_cast<std::size_t>(picture.rows - height + 1)));
  cv::Mat piece;
  cv::resize(picture(cv::Rect(left, top, width, height)), piece, size, 0, 0,
             times > 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
  if (dice.below(2) == 1) cv::flip(piece, piece, 1);
  return piece;
}

cv::Mat random_surface(const cv::Size& size, std::span<const cv::Mat> pictures, Dice& dice) {
  // Flat colours among photographs, too: most things have one.
  if (!pictures.empty() && dice.below(2) == 0)
    return random_piece(pictures[dice.below(pictures.size())], size, dice);
  const std::array<double, 3> colour = random_colour(dice);
  const double darkest = dice.between(0.5, 0.9), towards = dice.between(0, kFullTurn_rad);
  const double right = std::cos(towards) / size.width, down = std::sin(towards) / size.height;
  cv::Mat surface(size, CV_8UC3);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const double place =
          0.5 + (right * (x - size.width / 2.0) + down * (y - size.height / 2.0)) / 1.5;
      const double light = darkest + (1 - darkest) * place;
      for (int c = 0; c < 3; ++c)
        surface.at<cv::Vec3b>(y, x)[c] =
            cv::saturate_cast<std::uint8_t>(colour[static_cast<std::size_t>(c)] * light);
    }
  return surface;
}

void paint_shape(const cv::Mat& mask, std::span<const cv::Mat> pictures, Dice& dice, cv::Mat& rgb) {
  const cv::Rect box = cv::boundingRect(mask);
  if (box.empty()) return;
  random_surface(box.size(), pictures, dice).copyTo(rgb(box), mask(box));
}

}  // namespace aspect
