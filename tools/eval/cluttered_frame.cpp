// Idea: the background is painted first, then the object, then what hides it; the camera's faults
// come last, over all of it, so that borders of all kinds are blurred alike.
// What hides the object is a shape at a random place that is grown as far as the share to be hidden
// allows: what a shape covers, a larger one covers too, so that halving finds the size.
// Weak side: no shadows fall from one thing on another, and nothing is reflected.
#include "tools/eval/cluttered_frame.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "compiler/render/made_frame.h"
#include "compiler/render/sampling.h"
#include "tools/eval/clutter_shapes.h"

namespace aspect {
namespace {

constexpr double kFarthest = 2.2;  // in distances of the studio
constexpr double kUnhidden = 1.0 / 3;
constexpr double kLeastOccluder_px = 4;

cv::Point2d random_place(const cv::Rect2d& within, Dice& dice) {
  const double x = dice.between(within.x, within.x + within.width),
               y = dice.between(within.y, within.y + within.height);
  return {x, y};
}

// Where a thing that reaches so far is wholly in the picture, or in its middle.
double place_within(int size_px, double reach_px, Dice& dice) {
  const double middle = (size_px - 1) / 2.0, play = std::max(0.0, middle - reach_px);
  return middle + dice.between(-play, play);
}

Camera random_camera(const Scene& scene, Dice& dice) {
  const Studio& studio = scene.studio;
  const Eigen::Vector3d direction = dice.direction();
  const double distance = studio.distance * dice.between(1, kFarthest);
  const double roll_rad = dice.between(-std::numbers::pi, std::numbers::pi);
  Camera camera = camera_at(studio, direction, distance);
  camera.camera_from_object =
      Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
      camera.camera_from_object;
  const Intrinsics& lens = camera.intrinsics;
  const double radius = bounding_radius(scene) + studio.at.norm();
  // Beside the picture's middle a ball is seen somewhat longer.
  const double tangent =
      1.1 * radius / std::sqrt(std::max(1e-6, distance * distance - radius * radius));
  const double x = place_within(lens.width_px, lens.fx_px * tangent, dice),
               y = place_within(lens.height_px, lens.fy_px * tangent, dice);
  camera.position_object =
      studio.at - camera.camera_from_object.transpose() * lens.point_camera(x, y, distance);
  return camera;
}

class FrameInMaking {
 public:
  FrameInMaking(const Intrinsics& lens, const ClutterSettings& settings, Dice& dice)
      : size_(lens.width_px, lens.height_px),
        settings_(settings),
        dice_(dice),
        object_(cv::Mat::zeros(size_, CV_8U)),
        hidden_(cv::Mat::zeros(size_, CV_8U)) {}

  void add_background() {
    const auto& pictures = settings_.backgrounds;
    rgb_ = pictures.empty() ? random_surface(size_, {}, dice_)
                            : random_piece(pictures[dice_.below(pictures.size())], size_, dice_);
    const std::size_t shapes = pictures.empty() ? 8 + dice_.below(13) : dice_.below(5);
    for (std::size_t k = 0; k < shapes; ++k) add_shape(0.05, 0.3);
  }

  // Anywhere; of a radius of such a share of the picture's smaller side.
  void add_shape(double least, double most) {
    cv::Mat mask = cv::Mat::zeros(size_, CV_8U);
    const ClutterShape shape = random_shape(dice_);
    const cv::Point2d centre = random_place(cv::Rect2d({0, 0}, cv::Size2d(size_)), dice_);
    draw_shape(shape, centre, std::min(size_.width, size_.height) * dice_.between(least, most),
               mask);
    paint_shape(mask, settings_.backgrounds, dice_, rgb_);
  }

  void add_object(const Picture& picture) {
    for (int y = 0; y < size_.height; ++y)
      for (int x = 0; x < size_.width; ++x) {
        const auto pixel = static_cast<std::size_t>(y * size_.width + x);
        if (picture.surface[pixel] == 0) continue;
        const std::uint8_t* rgb = &picture.rgb[3 * pixel];
        object_.at<std::uint8_t>(y, x) = 255;
        rgb_.at<cv::Vec3b>(y, x) = {rgb[0], rgb[1], rgb[2]};
      }
    object_px_ = cv::countNonZero(object_);
  }

  // With one shape or two.
  void hide() {
    if (dice_.between(0, 1) < kUnhidden || object_px_ == 0) return;
    const double share = dice_.between(0, settings_.hidden_max);
    if (dice_.below(2) == 1) hide_up_to(share * dice_.between(0.3, 0.7));
    hide_up_to(share);
  }

  ClutteredFrame finished() {
    ClutteredFrame frame;
    frame.width_px = size_.width;
    frame.height_px = size_.height;
    frame.pixels.assign(object_.total(), ClutteredFrame::Pixel::other);
    for (std::size_t k = 0; k < frame.pixels.size(); ++k)
      if (object_.data[k] != 0)
        frame.pixels[k] =
            hidden_.data[k] != 0 ? ClutteredFrame::Pixel::hidden : ClutteredFrame::Pixel::visible;
    cv::Mat seen;
    cv::bitwise_and(object_, ~hidden_, seen);
    const cv::Rect box = cv::boundingRect(seen);
    frame.box = {box.x, box.y, box.width, box.height};
    if (object_px_ > 0)
      frame.visible = static_cast<double>(cv::countNonZero(seen)) / static_cast<double>(object_px_);
    MadeFrame made{size_.width, size_.height, {}};
    made.rgb.assign(rgb_.data, rgb_.data + 3 * rgb_.total());
    frame.rgb = photographed(std::move(made), dice_);
    return frame;
  }

 private:
  double hidden_share(const cv::Mat& hidden) const {
    cv::Mat both;
    cv::bitwise_and(object_, hidden, both);
    return static_cast<double>(cv::countNonZero(both)) / static_cast<double>(object_px_);
  }

  void hide_up_to(double share) {
    const ClutterShape shape = random_shape(dice_);
    cv::Rect2d around = cv::boundingRect(object_);
    const double margin = 0.15 * std::max(around.width, around.height);
    around.x -= margin, around.y -= margin, around.width += 2 * margin, around.height += 2 * margin;
    const cv::Point2d centre = random_place(around, dice_);
    double fits_px = 0, too_large_px = std::max(size_.width, size_.height);
    while (too_large_px - fits_px > 0.5) {
      const double tried_px = (fits_px + too_large_px) / 2;
      cv::Mat hidden = hidden_.clone();
      draw_shape(shape, centre, tried_px, hidden);
      (hidden_share(hidden) <= share ? fits_px : too_large_px) = tried_px;
    }
    if (fits_px < kLeastOccluder_px) return;
    cv::Mat mask = cv::Mat::zeros(size_, CV_8U);
    draw_shape(shape, centre, fits_px, mask);
    paint_shape(mask, settings_.backgrounds, dice_, rgb_);
    cv::bitwise_or(hidden_, mask, hidden_);
  }

  cv::Size size_;
  const ClutterSettings& settings_;
  Dice& dice_;
  cv::Mat rgb_, object_, hidden_;
  int object_px_ = 0;
};

}  // namespace

Dice dice_of_frame(std::uint64_t seed, std::size_t object, std::size_t number) {
  constexpr double kSeeds = 4294967296.0;
  return Dice(static_cast<std::size_t>(
      kSeeds * SampleKey().child(seed).child(object).child(number).number(0)));
}

ClutteredFrame make_cluttered_frame(const Scene& scene, const LitObject& object, bool with_object,
                                    const ClutterSettings& settings, Dice dice) {
  const Camera camera = random_camera(scene, dice);
  FrameInMaking made(camera.intrinsics, settings, dice);
  made.add_background();
  if (with_object) {
    Picture picture;
    const Eigen::Vector3d view = (camera.position_object - scene.studio.at).normalized();
    object.seen_from(view, dice).render(camera, picture);
    made.add_object(picture);
    made.hide();
  } else {
    for (std::size_t k = dice.below(3); k > 0; --k) made.add_shape(0.1, 0.4);
  }
  ClutteredFrame frame = made.finished();
  frame.has_object = with_object;
  frame.camera = camera;
  return frame;
}

}  // namespace aspect
