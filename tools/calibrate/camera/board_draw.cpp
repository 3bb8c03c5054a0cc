#include "tools/calibrate/camera/board_draw.h"

#include <fmt/format.h>

#include <opencv2/imgproc.hpp>

#include "tools/draw/id_colour.h"
#include "tools/draw/picture_text.h"

namespace aspect {
namespace {

constexpr int kShift = 4;  // binary places of drawn coordinates

cv::Point fine(const cv::Point2f& p) {
  return {cvRound(p.x * (1 << kShift)), cvRound(p.y * (1 << kShift))};
}

void draw_arrow(cv::Mat& picture, const cv::Point2f& from, const cv::Point2f& to) {
  const cv::Point2f tip = from + kResidualScale * (to - from);
  cv::line(picture, fine(from), fine(tip), {0, 0, 255}, 1, cv::LINE_AA, kShift);
  cv::circle(picture, fine(tip), 2 << kShift, {0, 0, 255}, cv::FILLED, cv::LINE_AA, kShift);
}

}  // namespace

cv::Mat draw_board(const cv::Mat& picture, const SeenBoard& seen, const Board& board,
                   const FittedPicture* fitted) {
  cv::Mat drawn = picture.clone();
  if (drawn.channels() == 1) cv::cvtColor(drawn, drawn, cv::COLOR_GRAY2BGR);
  const int columns = board.corner_columns();
  for (std::size_t k = 0; k < seen.points.size(); ++k) {
    const cv::Scalar colour = id_colour(seen.numbers[k] / columns);
    if (k > 0 && seen.numbers[k] == seen.numbers[k - 1] + 1 && seen.numbers[k] % columns != 0)
      cv::line(drawn, fine(seen.points[k - 1]), fine(seen.points[k]), colour, 1, cv::LINE_AA,
               kShift);
    cv::circle(drawn, fine(seen.points[k]), 4 << kShift, colour, 1, cv::LINE_AA, kShift);
    if (fitted != nullptr) draw_arrow(drawn, seen.points[k], fitted->drawn[k]);
  }
  std::string text =
      seen.empty() ? "no board found" : fmt::format("{} corners", seen.points.size());
  if (fitted != nullptr)
    text += fmt::format(", off by {:.2f} px (arrows x {})", fitted->residual_px, kResidualScale);
  draw_text(drawn, text, {8, 8}, text_style_for(drawn.size()));
  return drawn;
}

cv::Mat draw_coverage(const std::vector<BoardPicture>& pictures, const CameraFit& fit) {
  cv::Mat drawn(fit.height_px, fit.width_px, CV_8UC3, cv::Scalar(24, 24, 24));
  for (const BoardPicture& picture : pictures) {
    std::vector<cv::Point> points, hull;
    for (const cv::Point2f& p : picture.seen.points)
      points.emplace_back(cvRound(p.x), cvRound(p.y));
    cv::convexHull(points, hull);
    cv::fillConvexPoly(drawn, hull, {72, 72, 72});
  }
  for (std::size_t k = 0; k < pictures.size(); ++k)
    for (std::size_t p = 0; p < pictures[k].seen.points.size(); ++p) {
      const cv::Point2f& seen = pictures[k].seen.points[p];
      cv::circle(drawn, fine(seen), 1 << kShift, id_colour(static_cast<int>(k)), cv::FILLED,
                 cv::LINE_AA, kShift);
      draw_arrow(drawn, seen, fit.pictures[k].drawn[p]);
    }
  draw_text(drawn,
            fmt::format("{} pictures cover {:.0f} %, off by {:.3f} px (arrows x {})",
                        pictures.size(), 100 * fit.covered_share, fit.residual_px, kResidualScale),
            {8, 8}, text_style_for(drawn.size()));
  return drawn;
}

}  // namespace aspect
