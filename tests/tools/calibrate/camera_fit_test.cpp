// Cameras from pictures of boards whose camera is known.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/tools/calibrate/board_picture.h"
#include "tools/calibrate/camera/camera_fit.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;

Board small_board(Board::Kind kind) {
  Board board;
  board.kind = kind;
  board.columns = 8;
  board.rows = 5;
  return board;
}

std::vector<BoardPicture> pictures_of(const Board& board, const BoardStudio& studio,
                                      const std::vector<RigidPose>& poses) {
  std::vector<BoardPicture> pictures;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    SeenBoard seen = find_board(studio.take(poses[k], static_cast<unsigned>(k)), board);
    if (!seen.empty()) pictures.push_back({"picture " + std::to_string(k), std::move(seen)});
  }
  return pictures;
}

// Without pictures: where the camera has the corners, to a tenth of a pixel.
std::vector<BoardPicture> exact_pictures(const Board& board, const BoardStudio& studio,
                                         const std::vector<RigidPose>& poses) {
  std::vector<BoardPicture> pictures;
  cv::RNG dice(5);
  for (const RigidPose& pose : poses) {
    BoardPicture& picture = pictures.emplace_back();
    picture.name = "picture " + std::to_string(pictures.size());
    for (int number = 0; number < board.corners(); ++number) {
      const cv::Point2d p = studio.corner(pose, number);
      picture.seen.numbers.push_back(number);
      picture.seen.points.emplace_back(static_cast<float>(p.x + dice.gaussian(0.07)),
                                       static_cast<float>(p.y + dice.gaussian(0.07)));
    }
  }
  return pictures;
}

bool mentions(const std::vector<std::string>& warnings, const std::string& words) {
  return std::any_of(warnings.begin(), warnings.end(), [&](const std::string& warning) {
    return warning.find(words) != std::string::npos;
  });
}

TEST_CASE("Corners of both kinds of board are found to a fifth of a pixel") {
  const TakingCamera camera = wide_camera(480, 360);
  for (const Board::Kind kind : {Board::Kind::checkerboard, Board::Kind::charuco}) {
    const Board board = small_board(kind);
    const BoardStudio studio(board, camera);
    const bool whole = kind == Board::Kind::checkerboard;
    std::size_t corners = 0;
    double squares = 0;
    for (const RigidPose& pose : studio.poses(3, 2, whole)) {
      const SeenBoard seen = find_board(studio.take(pose, 1), board);
      CHECK(seen.numbers.size() >= (whole ? 28U : 9U));
      // OpenCV may begin at a checkerboard's other end, which says the same of a camera.
      const bool upright =
          std::abs(studio.corner(pose, seen.numbers[0]).x - double{seen.points[0].x}) < 5;
      CHECK((upright || whole));
      for (std::size_t k = 0; k < seen.numbers.size(); ++k) {
        const cv::Point2d truth =
            studio.corner(pose, upright ? seen.numbers[k] : 27 - seen.numbers[k]);
        const double off =
            std::hypot(double{seen.points[k].x} - truth.x, double{seen.points[k].y} - truth.y);
        CHECK(off < 1);
        squares += off * off;
        ++corners;
      }
    }
    CHECK(std::sqrt(squares / static_cast<double>(corners)) < 0.2);
  }
}

TEST_CASE("A camera is measured to 0.3 % and a pixel from twelve pictures of a checkerboard") {
  const Board board = small_board(Board::Kind::checkerboard);
  const TakingCamera camera = wide_camera(480, 360);
  const BoardStudio studio(board, camera);
  auto pictures = pictures_of(board, studio, studio.poses(12, 4, true));
  CHECK(pictures.size() >= 11);
  const auto fit = fit_camera(pictures, board, {camera.width_px, camera.height_px});
  INFO((fit ? "" : fit.error()));
  REQUIRE(fit);
  CHECK(std::abs(fit.value().model.fx_px / camera.model.fx_px - 1) < 0.003);
  CHECK(std::abs(fit.value().model.fy_px / camera.model.fy_px - 1) < 0.003);
  CHECK(std::abs(fit.value().model.cx_px - camera.model.cx_px) < 1);
  CHECK(std::abs(fit.value().model.cy_px - camera.model.cy_px) < 1);
  CHECK(fit.value().residual_px < 0.15);
  // The picture's corner is bent by the fitted lens as by the true one.
  const Point2d truth = camera.model.bent({20, 20}), fitted = fit.value().model.bent({20, 20});
  CHECK(std::hypot(truth.x - fitted.x, truth.y - fitted.y) < 1.5);
}

TEST_CASE("A few corners that are elsewhere are left out, and said") {
  const Board board = small_board(Board::Kind::charuco);
  const TakingCamera camera = wide_camera(640, 480);
  const BoardStudio studio(board, camera);
  auto pictures = exact_pictures(board, studio, studio.poses(12, 7, true));
  pictures[2].seen.points[5].x += 9;
  pictures[6].seen.points[11].y -= 15;
  const auto fit = fit_camera(pictures, board, {640, 480});
  REQUIRE(fit);
  CHECK(fit.value().dropped_corners == 2);
  CHECK(pictures[2].seen.numbers.size() == 27);
  CHECK(fit.value().residual_px < 0.12);
  CHECK(std::abs(fit.value().model.fx_px / camera.model.fx_px - 1) < 0.003);
  CHECK(mentions(fit_warnings(fit.value(), pictures), "2 corners lay far off"));
}

TEST_CASE("What makes a calibration doubtful is warned of") {
  const Board board = small_board(Board::Kind::checkerboard);
  const BoardStudio studio(board, wide_camera(640, 480));
  const std::vector<RigidPose> poses = studio.poses(14, 3, true);
  const auto warnings_of = [&](std::vector<BoardPicture> pictures) {
    const auto fit = fit_camera(pictures, board, {640, 480});
    REQUIRE(fit);
    return fit_warnings(fit.value(), pictures);
  };
  const auto all = exact_pictures(board, studio, poses);
  CHECK_FALSE(mentions(warnings_of(all), "few"));
  CHECK_FALSE(mentions(warnings_of(all), "side"));
  CHECK_FALSE(mentions(warnings_of(all), "off by"));

  CHECK(mentions(warnings_of({all.begin(), all.begin() + 5}), "5 pictures are few"));

  std::vector<BoardPicture> one_side;
  for (std::size_t k = 0; k < poses.size(); ++k)
    if (poses[k].rotation.rows()[0][2] > 0.2) one_side.push_back(all[k]);
  REQUIRE(one_side.size() >= kLeastBoardPictures);
  const auto sided = warnings_of(one_side);
  CHECK((mentions(sided, "from one side") || mentions(sided, "is turned by no more than")));

  std::vector<BoardPicture> upright = all;
  std::vector<RigidPose> flat = poses;
  for (std::size_t k = 0; k < flat.size(); ++k) {
    flat[k].rotation = turn_about({1, 0, 0}, 0.02 * static_cast<double>(k % 5));
    flat[k].translation = {-100.0 + 3.0 * static_cast<double>(k), -60,
                           420.0 + 9.0 * static_cast<double>(k)};
  }
  CHECK(mentions(warnings_of(exact_pictures(board, studio, flat)),
                 "says little of the focal length"));

  // Seen from far away in the picture's middle.
  for (RigidPose& pose : flat) pose.translation[2] = 900;
  for (std::size_t k = 0; k < flat.size(); ++k) flat[k].rotation = poses[k].rotation;
  CHECK(mentions(warnings_of(exact_pictures(board, studio, flat)), "corners cover"));

  // A page that was bent.
  std::vector<BoardPicture> bent = all;
  for (std::size_t p = 0; p < bent[4].seen.points.size(); ++p)
    bent[4].seen.points[p].y += 4 * std::sin(0.7F * static_cast<float>(p % 7));
  const auto warnings = warnings_of(bent);
  CHECK((mentions(warnings, "worst: picture 5") ||
         mentions(warnings, "look at them or leave them out: picture 5")));
}

TEST_CASE("Two pictures, and pictures that say no camera, are one line of error") {
  const Board board = small_board(Board::Kind::checkerboard);
  const BoardStudio studio(board, wide_camera(640, 480));
  auto two = exact_pictures(board, studio, studio.poses(2, 1, true));
  CHECK_THAT(fit_camera(two, board, {640, 480}).error(), Contains("found in 2 pictures"));
  std::vector<BoardPicture> same(4, two.front());
  for (BoardPicture& picture : same)
    for (cv::Point2f& p : picture.seen.points) p = {100, 100};
  CHECK_FALSE(fit_camera(same, board, {640, 480}));
  CHECK(find_board(cv::Mat(240, 320, CV_8U, cv::Scalar(90)), board).empty());
}

}  // namespace
}  // namespace aspect
