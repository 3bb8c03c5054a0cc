#include "tests/tools/calibrate/board_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "tools/calibrate/board/markers.h"

namespace aspect {
namespace {

constexpr int kSide = 3;  // rays along a pixel's side
constexpr double kWhite = 215, kBlack = 35, kBehind = 110;

cv::Matx33d matrix_of(const CameraModel& m) {
  return {m.fx_px, 0, m.cx_px, 0, m.fy_px, m.cy_px, 0, 0, 1};
}
cv::Vec<double, 5> bends_of(const CameraModel& m) {
  return {m.k1, m.k2, m.p1, m.p2, m.k3};
}

bool is_black_at(const Board& board, double x_mm, double y_mm) {
  const int column = static_cast<int>(std::floor(x_mm / board.square_mm)),
            row = static_cast<int>(std::floor(y_mm / board.square_mm));
  if (column < 0 || row < 0 || column >= board.columns || row >= board.rows) return false;
  if (board.is_black(column, row)) return true;
  if (board.kind == Board::Kind::checkerboard) return false;
  const double free = (board.square_mm - board.marker_mm) / 2;
  const int cells = board.marker_side + 2;
  const double cell = board.marker_mm / cells;
  const int x = static_cast<int>(std::floor((x_mm - column * board.square_mm - free) / cell)),
            y = static_cast<int>(std::floor((y_mm - row * board.square_mm - free) / cell));
  if (x < 0 || y < 0 || x >= cells || y >= cells) return false;
  const int before = (row * board.columns + column) / 2;  // white squares, row by row
  return !is_white_cell(board.marker_side, before, x, y);
}

// Of the board's white paper, one square around the pattern.
bool is_paper_at(const Board& board, double x_mm, double y_mm) {
  const double rim = board.square_mm;
  return x_mm > -rim && y_mm > -rim && x_mm < board.columns * rim + rim &&
         y_mm < board.rows * rim + rim;
}

double uniform(cv::RNG& dice, double low, double high) {
  return dice.uniform(low, high);
}

}  // namespace

TakingCamera wide_camera(int width_px, int height_px) {
  TakingCamera camera;
  const double f = 0.95 * width_px;
  camera.model = {f,       1.004 * f, 0.512 * width_px, 0.487 * height_px, -0.21, 0.09, 0.0008,
                  -0.0006, -0.012};
  camera.width_px = width_px;
  camera.height_px = height_px;
  return camera;
}

BoardStudio::BoardStudio(const Board& board, const TakingCamera& camera)
    : board_(board), camera_(camera) {}

const std::vector<cv::Point2f>& BoardStudio::rays() const {
  if (!rays_.empty()) return rays_;
  std::vector<cv::Point2f> bent;
  for (int y = 0; y < camera_.height_px; ++y)
    for (int x = 0; x < camera_.width_px; ++x)
      for (int s = 0; s < kSide * kSide; ++s)
        bent.emplace_back(static_cast<float>(x + (s % kSide + 0.5) / kSide - 0.5),
                          static_cast<float>(y + (s / kSide + 0.5) / kSide - 0.5));
  cv::undistortPoints(bent, rays_, matrix_of(camera_.model), bends_of(camera_.model), cv::noArray(),
                      cv::noArray(), {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 30, 1e-9});
  return rays_;
}

cv::Mat BoardStudio::take(const RigidPose& camera_from_board, unsigned seed) const {
  const auto r = camera_from_board.rotation.rows();
  const Vector3d& t = camera_from_board.translation;
  // From a ray to the plane z = 0 of the board.
  const cv::Matx33d from_board(r[0][0], r[0][1], t[0], r[1][0], r[1][1], t[1], r[2][0], r[2][1],
                               t[2]);
  const cv::Matx33d m = from_board.inv();
  cv::Mat picture(camera_.height_px, camera_.width_px, CV_32F);
  const std::vector<cv::Point2f>& all = rays();
  std::size_t k = 0;
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x) {
      double sum = 0;
      for (int s = 0; s < kSide * kSide; ++s, ++k) {
        const double u = double{all[k].x}, v = double{all[k].y};
        const double w = m(2, 0) * u + m(2, 1) * v + m(2, 2);
        const double x_mm = (m(0, 0) * u + m(0, 1) * v + m(0, 2)) / w,
                     y_mm = (m(1, 0) * u + m(1, 1) * v + m(1, 2)) / w;
        if (w > 0 && is_black_at(board_, x_mm, y_mm))
          sum += kBlack;
        else
          sum += w > 0 && is_paper_at(board_, x_mm, y_mm) ? kWhite : kBehind;
      }
      // Light from one side.
      picture.at<float>(y, x) =
          static_cast<float>(sum / (kSide * kSide) * (0.8 + 0.3 * x / picture.cols));
    }
  if (camera_.blur_px > 0) cv::GaussianBlur(picture, picture, {}, camera_.blur_px);
  cv::Mat noise(picture.size(), CV_32F), seen;
  cv::RNG dice(seed);
  dice.fill(noise, cv::RNG::NORMAL, 0, camera_.noise);
  cv::Mat(picture + noise).convertTo(seen, CV_8U);
  return seen;
}

cv::Point2d BoardStudio::corner(const RigidPose& camera_from_board, int number) const {
  const Point2d mm = board_.corner_mm(number);
  const Vector3d p = camera_from_board({mm.x, mm.y, 0});
  std::vector<cv::Point2d> seen;
  cv::projectPoints(std::vector<cv::Point3d>{{p[0], p[1], p[2]}}, cv::Vec3d(0, 0, 0),
                    cv::Vec3d(0, 0, 0), matrix_of(camera_.model), bends_of(camera_.model), seen);
  return seen.front();
}

std::vector<RigidPose> BoardStudio::poses(int count, unsigned seed, bool whole) const {
  constexpr double kRim_px = 8;
  cv::RNG dice(seed);
  std::vector<RigidPose> found;
  const Vector3d middle{board_.columns * board_.square_mm / 2, board_.rows * board_.square_mm / 2,
                        0};
  while (static_cast<int>(found.size()) < count) {
    // To all sides in turn, and to all places.
    const int k = static_cast<int>(found.size());
    const double towards = 2 * std::numbers::pi * (k * 0.382 + uniform(dice, -0.05, 0.05)),
                 tilt = uniform(dice, 15, 40) * std::numbers::pi / 180;
    RigidPose pose;
    pose.rotation = turn_about({std::cos(towards), std::sin(towards), 0}, tilt) *
                    turn_about({0, 0, 1}, uniform(dice, -0.4, 0.4));
    const double distance = board_.columns * board_.square_mm * camera_.model.fx_px /
                            (camera_.width_px * uniform(dice, 0.45, 0.75));
    const Vector3d at{uniform(dice, -0.5, 0.5) * camera_.width_px / camera_.model.fx_px * distance,
                      uniform(dice, -0.5, 0.5) * camera_.height_px / camera_.model.fy_px * distance,
                      distance};
    pose.translation = at - pose.rotation(middle);
    int inside = 0;
    for (int number = 0; number < board_.corners(); ++number) {
      const cv::Point2d p = corner(pose, number);
      inside += p.x > kRim_px && p.y > kRim_px && p.x < camera_.width_px - kRim_px &&
                p.y < camera_.height_px - kRim_px;
    }
    if (inside == board_.corners() || (!whole && 2 * inside >= board_.corners()))
      found.push_back(pose);
  }
  return found;
}

}  // namespace aspect
