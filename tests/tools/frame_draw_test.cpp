#include <array>
#include <catch2/catch.hpp>
#include <vector>

#include "tools/draw/frame_canvas.h"
#include "tools/draw/id_colour.h"
#include "tools/draw/recognition_draw.h"
#include "tools/draw/region_draw.h"

namespace aspect {
namespace {

// A red and a green rectangle side by side on black, seen by Vision.
class TwoRectangles {
 public:
  TwoRectangles() : picture_(480, 640, CV_8UC3, cv::Scalar(0, 0, 0)) {
    picture_(left()).setTo(cv::Scalar(0, 0, 220));
    picture_(right()).setTo(cv::Scalar(0, 220, 0));
    Arena counted;
    Vision().prepare(counted, picture_.cols, picture_.rows);
    storage_.resize(counted.used_bytes() + 64);
    Arena arena(storage_);
    vision_.prepare(arena, picture_.cols, picture_.rows);
    graph_ = vision_.run(frame(), VisionParameters());
  }

  static cv::Rect left() { return {100, 150, 150, 200}; }
  static cv::Rect right() { return {250, 150, 150, 200}; }
  Frame frame() const {
    return {picture_.data, picture_.cols, picture_.rows, std::ptrdiff_t{3} * picture_.cols,
            PixelFormat::bgr8};
  }
  const ViewGraph& graph() const { return graph_; }
  const RegionMap& regions() const { return vision_.regions(); }

 private:
  cv::Mat picture_;
  std::vector<std::byte> storage_;
  Vision vision_;
  ViewGraph graph_;
};

cv::Vec3b rounded(const cv::Scalar& colour) {
  return {cv::saturate_cast<uchar>(colour[0]), cv::saturate_cast<uchar>(colour[1]),
          cv::saturate_cast<uchar>(colour[2])};
}

TEST_CASE("Colours of ids are stable, bright and different from their neighbours") {
  for (int id = 0; id < 200; ++id) {
    const cv::Vec3b colour = rounded(id_colour(id));
    CHECK(colour == rounded(id_colour(id)));
    CHECK(std::max({colour[0], colour[1], colour[2]}) == 255);
    for (int near = id + 1; near < id + 4; ++near)
      CHECK(cv::norm(colour, rounded(id_colour(near)), cv::NORM_L1) > 60);
  }
}

TEST_CASE("A region map shows every region in the colour of its label") {
  const TwoRectangles seen;
  REQUIRE(seen.graph().contours.size() == 2);
  const cv::Mat map = draw_regions(seen.regions(), seen.graph(), 640, 480);
  REQUIRE(map.size() == cv::Size(640, 480));
  CHECK(map.at<cv::Vec3b>(160, 110) == rounded(id_colour(1)));
  CHECK(map.at<cv::Vec3b>(160, 390) == rounded(id_colour(2)));
  CHECK(map.at<cv::Vec3b>(10, 10) == cv::Vec3b(28, 28, 28));
}

TEST_CASE("A recognition is drawn over its frame") {
  const TwoRectangles seen;
  std::vector<ClassIndex> indexes(1);
  indexes[0].object = "two";
  const std::array matches = {ContourMatch{0, 0}, ContourMatch{1, 1}};
  Hypothesis best;
  best.contours = matches;
  const std::array hypotheses = {best};
  const std::array objects = {SeenObject{{100, 150, 300, 200}, 2, {}, hypotheses}};
  Recognition recognition;
  recognition.graph = seen.graph();
  recognition.objects = objects;
  const cv::Mat overlay = draw_recognition(seen.frame(), recognition, seen.regions(), indexes);
  REQUIRE(overlay.size() == cv::Size(640, 480));
  CHECK(overlay.at<cv::Vec3b>(200, 120) == cv::Vec3b(0, 0, 220));
  CHECK(overlay.at<cv::Vec3b>(5, 600) == cv::Vec3b(0, 0, 0));
  CHECK(overlay.at<cv::Vec3b>(250, 249) == rounded(id_colour(1)));
  CHECK(overlay.at<cv::Vec3b>(250, 250) == rounded(id_colour(2)));
  const cv::Mat caption = overlay(cv::Rect(100, 125, 300, 20));
  CHECK(cv::countNonZero(caption.clone().reshape(1)) > 300);
}

TEST_CASE("Small frames are blown up for drawing") {
  for (const auto& [width, height] : {std::pair{1, 1}, {160, 120}, {7, 300}, {4000, 2}}) {
    const FrameCanvas canvas(cv::Mat(height, width, CV_8UC3, cv::Scalar(0, 0, 0)));
    FrameCanvas copy = canvas;
    CHECK(copy.picture().cols == width * canvas.scale());
    CHECK(copy.picture().rows == height * canvas.scale());
    CHECK(canvas.scale() >= 1);
    CHECK(canvas.scale() <= 8);
  }
  CHECK(FrameCanvas(cv::Mat(480, 640, CV_8UC3)).scale() == 1);
}

TEST_CASE("A label stands within its region even if the region's centre does not") {
  const std::array runs = {Run{0, 0, 10, 1}, Run{1, 0, 2, 1}, Run{2, 4, 9, 2}};
  RegionMap map;
  map.runs = runs;
  Contour contour;
  contour.region = 1;
  contour.centre_px = {5, 2};
  const Point2 point = label_point(contour, map);
  CHECK(point.x == 5);
  CHECK(point.y == 0);
}

TEST_CASE("Text of any length and letters is drawn without leaving the picture") {
  cv::Mat picture(30, 60, CV_8UC3, cv::Scalar(0, 0, 0));
  const TextStyle style = text_style_for(picture.size());
  draw_text(picture, std::string(500, 'x'), {-10, 500}, style);
  draw_text(picture, "W\xC3\xBCrfel\n\xFF", {50, 20}, style);
  draw_text(picture, "", {0, 0}, style);
  CHECK(cv::countNonZero(picture.reshape(1)) > 0);
}

}  // namespace
}  // namespace aspect
