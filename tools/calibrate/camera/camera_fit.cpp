#include "tools/calibrate/camera/camera_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

namespace aspect {
namespace {

struct Solved {
  cv::Mat matrix, bends, errors, residuals;
  std::vector<cv::Mat> turns, shifts;
  double residual_px = 0;
};

std::vector<std::vector<cv::Point3f>> points_on_board(const std::vector<BoardPicture>& pictures,
                                                      const Board& board) {
  std::vector<std::vector<cv::Point3f>> all;
  for (const BoardPicture& picture : pictures) {
    auto& points = all.emplace_back();
    for (const int number : picture.seen.numbers) {
      const Point2d mm = board.corner_mm(number);
      points.emplace_back(static_cast<float>(mm.x), static_cast<float>(mm.y), 0.0F);
    }
  }
  return all;
}

// Corners are as exact as they are: nothing is gained beyond some fifty rounds.
Solved solve(const std::vector<std::vector<cv::Point3f>>& on_board,
             const std::vector<std::vector<cv::Point2f>>& in_picture, cv::Size size, int flags) {
  Solved solved;
  cv::Mat ignored;
  solved.residual_px =
      cv::calibrateCamera(on_board, in_picture, size, solved.matrix, solved.bends, solved.turns,
                          solved.shifts, solved.errors, ignored, solved.residuals, flags,
                          {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 60, 1e-10});
  return solved;
}

CameraModel model_of(const Solved& solved) {
  const auto k = [&](int row, int column) { return solved.matrix.at<double>(row, column); };
  const auto bend = [&](int place) { return solved.bends.at<double>(place); };
  return {k(0, 0), k(1, 1), k(0, 2), k(1, 2), bend(0), bend(1), bend(2), bend(3), bend(4)};
}

// In the order of OpenCV's: fx fy cx cy k1 k2 p1 p2 k3.
bool knows_k3(const Solved& solved) {
  constexpr int kPlace = 8;
  constexpr double kSure = 3;  // standard deviations
  return std::abs(solved.bends.at<double>(4)) > kSure * solved.errors.at<double>(kPlace);
}

double covered_share(const std::vector<BoardPicture>& pictures, cv::Size size) {
  constexpr double kMostSide_px = 640;
  const double scale = std::min(1.0, kMostSide_px / std::max(size.width, size.height));
  cv::Mat covered =
      cv::Mat::zeros(cvRound(size.height * scale), cvRound(size.width * scale), CV_8U);
  for (const BoardPicture& picture : pictures) {
    std::vector<cv::Point> points, hull;
    for (const cv::Point2f& p : picture.seen.points)
      points.emplace_back(cvRound(scale * double{p.x}), cvRound(scale * double{p.y}));
    cv::convexHull(points, hull);
    cv::fillConvexPoly(covered, hull, cv::Scalar(255));
  }
  return static_cast<double>(cv::countNonZero(covered)) / static_cast<double>(covered.total());
}

FittedPicture fitted_picture(const Solved& solved, std::size_t k,
                             const std::vector<cv::Point3f>& on_board) {
  FittedPicture fitted;
  fitted.residual_px = solved.residuals.at<double>(static_cast<int>(k));
  cv::projectPoints(on_board, solved.turns[k], solved.shifts[k], solved.matrix, solved.bends,
                    fitted.drawn);
  cv::Mat rotation;
  cv::Rodrigues(solved.turns[k], rotation);
  for (int row = 0; row < 3; ++row) fitted.normal_camera[row] = rotation.at<double>(row, 2);
  if (fitted.normal_camera[2] < 0) fitted.normal_camera *= -1.0;
  return fitted;
}

// Degrees between the boards that are turned most against each other.
double largest_turn_deg(const CameraFit& fit) {
  double least = 1;
  for (const FittedPicture& a : fit.pictures)
    for (const FittedPicture& b : fit.pictures)
      least = std::min(least, a.normal_camera.dot(b.normal_camera));
  return std::acos(std::clamp(least, -1.0, 1.0)) * 180 / CV_PI;
}

// How far the boards' tilts have one direction: 1 where all lean the same way, 0 where each has
// another that leans against it.
double one_sidedness(const CameraFit& fit) {
  cv::Vec2d sum(0, 0);
  double lengths = 0;
  for (const FittedPicture& picture : fit.pictures) {
    const cv::Vec2d tilt(picture.normal_camera[0], picture.normal_camera[1]);
    sum += tilt;
    lengths += cv::norm(tilt);
  }
  return lengths > 0 ? cv::norm(sum) / lengths : 1;
}

std::string worst_pictures(const CameraFit& fit, const std::vector<BoardPicture>& pictures) {
  constexpr std::size_t kMostNamed = 3;
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < fit.pictures.size(); ++k) order.push_back(k);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return fit.pictures[a].residual_px > fit.pictures[b].residual_px;
  });
  order.resize(std::min(order.size(), kMostNamed));
  std::vector<std::string> names;
  for (const std::size_t k : order)
    names.push_back(fmt::format("{} ({:.2f})", pictures[k].name, fit.pictures[k].residual_px));
  return fmt::format("{}", fmt::join(names, ", "));
}

Result<CameraFit> fit_once(const std::vector<BoardPicture>& pictures, const Board& board,
                           cv::Size size) {
  if (pictures.size() < kLeastBoardPictures)
    return Error{
        fmt::format("the board is found in {} pictures; {} are the least, 10 to 20 are good",
                    pictures.size(), kLeastBoardPictures)};
  const auto on_board = points_on_board(pictures, board);
  std::vector<std::vector<cv::Point2f>> in_picture;
  for (const BoardPicture& picture : pictures) in_picture.push_back(picture.seen.points);
  CameraFit fit;
  Solved solved;
  try {
    solved = solve(on_board, in_picture, size, 0);
    fit.has_k3 = knows_k3(solved) && is_sound(model_of(solved), size.width, size.height);
    if (!fit.has_k3) solved = solve(on_board, in_picture, size, cv::CALIB_FIX_K3);
  } catch (const cv::Exception&) {
    return Error{"the pictures do not say a camera: turn the board, and come nearer"};
  }
  fit.model = model_of(solved);
  if (!is_sound(fit.model, size.width, size.height))
    return Error{
        "the fitted lens folds the picture; take pictures with the board near all four corners, "
        "turned by 20 to 40 degrees, and leave blurred ones out"};
  fit.width_px = size.width;
  fit.height_px = size.height;
  fit.residual_px = solved.residual_px;
  const auto error = [&](int place) { return solved.errors.at<double>(place); };
  fit.fx_error_px = error(0);
  fit.fy_error_px = error(1);
  fit.cx_error_px = error(2);
  fit.cy_error_px = error(3);
  for (std::size_t k = 0; k < pictures.size(); ++k)
    fit.pictures.push_back(fitted_picture(solved, k, on_board[k]));
  fit.covered_share = covered_share(pictures, size);
  return fit;
}

// Whether each corner is within `far_px` of where a pose on which most of them agree has it, under
// the fitted camera; empty where too few agree: a picture that is bad as a whole keeps its corners.
std::vector<bool> agreeing_corners(const CameraFit& fit, const Board& board, const SeenBoard& seen,
                                   double far_px) {
  constexpr double kMost = 0.6;
  constexpr int kTries = 200;
  const auto on_board = points_on_board({{"", seen}}, board).front();
  const CameraModel& m = fit.model;
  const cv::Matx33d matrix(m.fx_px, 0, m.cx_px, 0, m.fy_px, m.cy_px, 0, 0, 1);
  const cv::Vec<double, 5> bends(m.k1, m.k2, m.p1, m.p2, m.k3);
  cv::Mat turn, shift, inside;
  if (!cv::solvePnPRansac(on_board, seen.points, matrix, bends, turn, shift, false, kTries,
                          static_cast<float>(far_px), 0.999, inside) ||
      static_cast<double>(inside.total()) < kMost * static_cast<double>(seen.points.size()))
    return {};
  std::vector<bool> agree(seen.points.size());
  for (int k = 0; k < static_cast<int>(inside.total()); ++k)
    agree[static_cast<std::size_t>(inside.at<int>(k))] = true;
  return agree;
}

// One corner far off draws its whole picture along. How many went.
std::size_t drop_far_corners(const CameraFit& fit, const Board& board,
                             std::vector<BoardPicture>& pictures) {
  constexpr double kDoubtful = 2, kFar = 5, kLeastFar_px = 0.4;
  std::vector<double> residuals;
  for (const FittedPicture& picture : fit.pictures) residuals.push_back(picture.residual_px);
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  std::nth_element(residuals.begin(), middle, residuals.end());
  std::size_t dropped = 0;
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    if (fit.pictures[k].residual_px < kDoubtful * *middle) continue;
    const std::vector<bool> agree =
        agreeing_corners(fit, board, pictures[k].seen, std::max(kLeastFar_px, kFar * *middle));
    SeenBoard kept;
    for (std::size_t p = 0; p < agree.size(); ++p) {
      if (!agree[p]) continue;
      kept.numbers.push_back(pictures[k].seen.numbers[p]);
      kept.points.push_back(pictures[k].seen.points[p]);
    }
    if (!spans_an_area(kept, board)) continue;
    dropped += agree.size() - kept.numbers.size();
    pictures[k].seen = std::move(kept);
  }
  return dropped;
}

}  // namespace

Result<CameraFit> fit_camera(std::vector<BoardPicture>& pictures, const Board& board,
                             cv::Size size) {
  constexpr int kMostRounds = 4;
  std::size_t dropped = 0;
  for (int round = 0;; ++round) {
    Result<CameraFit> fit = fit_once(pictures, board, size);
    if (!fit) return fit;
    const std::size_t now =
        round < kMostRounds ? drop_far_corners(fit.value(), board, pictures) : 0;
    dropped += now;
    fit.value().dropped_corners = dropped;
    if (now == 0) return fit;
  }
}

std::vector<std::string> fit_warnings(const CameraFit& fit,
                                      const std::vector<BoardPicture>& pictures) {
  // A tenth of a pixel and less is usual at 640 x 480; lenses are not sharper in larger pictures.
  constexpr double kHigh = 0.5 / 640, kOutlier = 2.5, kUncertain = 0.005, kLeastTurn_deg = 25,
                   kOneSided = 0.6;
  constexpr std::size_t kFew = 8, kManyDropped = 20;
  std::vector<std::string> warnings;
  if (pictures.size() < kFew)
    warnings.push_back(fmt::format("{} pictures are few; take 10 to 20", pictures.size()));
  if (fit.covered_share < 0.5)
    warnings.push_back(fmt::format(
        "corners cover {:.0f} % of the picture: the lens is guessed where there are none; take "
        "pictures with the board near all its corners{}",
        100 * fit.covered_share,
        pictures.empty() ? "" : " (a ChArUco board may be cut off by the rim)"));
  if (largest_turn_deg(fit) < kLeastTurn_deg)
    warnings.push_back(fmt::format(
        "the board is turned by no more than {:.0f} degrees between pictures, which says little of "
        "the focal length; turn it by 20 to 40 degrees, to all sides",
        largest_turn_deg(fit)));
  else if (one_sidedness(fit) > kOneSided)
    warnings.push_back(
        "all pictures are taken from one side; tilt the board to the other sides, too");
  std::vector<double> residuals;
  for (const FittedPicture& picture : fit.pictures) residuals.push_back(picture.residual_px);
  std::sort(residuals.begin(), residuals.end());
  const double high_px = std::max(0.5, kHigh * fit.width_px);
  if (fit.residual_px > high_px)
    warnings.push_back(fmt::format(
        "the corners are off by {:.2f} px, more than {:.2f}: blur, a board that is not flat, or "
        "another board than the options say; worst: {}",
        fit.residual_px, high_px, worst_pictures(fit, pictures)));
  else if (residuals.back() > kOutlier * residuals[residuals.size() / 2] && residuals.back() > 0.3)
    warnings.push_back("pictures that fit worse than the others; look at them or leave them out: " +
                       worst_pictures(fit, pictures));
  if (fit.dropped_corners > 0)
    warnings.push_back(
        fmt::format("{} corners lay far off and were left out{}", fit.dropped_corners,
                    fit.dropped_corners > kManyDropped ? "; is the board the right one?" : ""));
  if (fit.fx_error_px > kUncertain * fit.model.fx_px)
    warnings.push_back(
        fmt::format("the focal length is known to {:.1f} % only; more pictures, turned more",
                    100 * fit.fx_error_px / fit.model.fx_px));
  return warnings;
}

}  // namespace aspect
