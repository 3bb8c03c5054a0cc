#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "runtime/recognition/model_lines.h"
#include "tests/runtime/recognition/painted_box.h"
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
  const cv::Mat map = draw_regions(seen.regions(), 640, 480);
  REQUIRE(map.size() == cv::Size(640, 480));
  CHECK(map.at<cv::Vec3b>(160, 110) == rounded(id_colour(1)));
  CHECK(map.at<cv::Vec3b>(160, 390) == rounded(id_colour(2)));
  CHECK(map.at<cv::Vec3b>(10, 10) == cv::Vec3b(0, 0, 0));
  // Numbers would hide regions that are smaller than they are.
  CHECK(cv::norm(map, draw_numbered_regions(seen.regions(), seen.graph(), 640, 480)) > 0);
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
  const cv::Mat overlay = draw_recognition(seen.frame(), recognition, seen.regions(), indexes, {});
  REQUIRE(overlay.size() == cv::Size(640, 480));
  CHECK(overlay.at<cv::Vec3b>(200, 120) == cv::Vec3b(0, 0, 220));
  CHECK(overlay.at<cv::Vec3b>(5, 600) == cv::Vec3b(0, 0, 0));
  CHECK(overlay.at<cv::Vec3b>(250, 249) == rounded(id_colour(1)));
  CHECK(overlay.at<cv::Vec3b>(250, 250) == rounded(id_colour(2)));
  const cv::Mat caption = overlay(cv::Rect(100, 125, 300, 20));
  CHECK(cv::countNonZero(caption.clone().reshape(1)) > 300);
}

// A cube of side 2 about the origin, every face of its own colour.
ObjectModel cube() {
  return prepared_model(painted_box(1, 1, 1), 3, 60);
}

// Six units before the camera, its face of 200 pixels' side towards it.
const RigidPose kStraightAhead{{}, {0, 0, 6}};
const CameraModel kCamera{500, 500, 319.5, 239.5};

TEST_CASE("A camera's own format is shown in its colours") {
  cv::Mat words(48, 64, CV_8UC2), expected;
  for (int y = 0; y < words.rows; ++y)
    for (int x = 0; x < words.cols; ++x)
      words.at<cv::Vec2b>(y, x) =
          cv::Vec2b(static_cast<std::uint8_t>(60 + 2 * x),
                    static_cast<std::uint8_t>(x % 2 == 0 ? 90 + y : 170 - y));
  const Frame frame = {words.data, words.cols, words.rows, std::ptrdiff_t{2} * words.cols,
                       PixelFormat::yuyv8};
  cv::cvtColor(words, expected, cv::COLOR_YUV2BGR_YUY2);
  const cv::Mat shown = picture_of(frame);
  REQUIRE(shown.type() == CV_8UC3);
  CHECK(cv::norm(shown, expected, cv::NORM_INF) <= 3);
}

TEST_CASE("A match is drawn with the edges and the axes of its pose") {
  const TwoRectangles seen;
  std::vector<ClassIndex> indexes(1);
  indexes[0].object = "cube";
  indexes[0].model = cube();
  const std::array cameras = {kCamera};
  VerifiedPose pose;
  pose.refined.pose = kStraightAhead;
  Hypothesis best;
  best.pose = &pose;
  const std::array hypotheses = {best};
  const auto drawn_as = [&](Verdict verdict) {
    const std::array objects = {
        SeenObject{{100, 150, 300, 200}, 2, {verdict, 0.75F, {}, 0}, hypotheses}};
    Recognition recognition;
    recognition.graph = seen.graph();
    recognition.objects = objects;
    return draw_recognition(seen.frame(), recognition, seen.regions(), indexes, cameras);
  };
  const cv::Vec3b green(0, 220, 0);
  for (const Verdict verdict : {Verdict::match, Verdict::ambiguous}) {
    const cv::Mat overlay = drawn_as(verdict);
    // The edges of the face in front; the one behind it is 143 pixels wide.
    CHECK(overlay.at<cv::Vec3b>(300, 420) == rounded(kModelEdgeColour));
    CHECK(overlay.at<cv::Vec3b>(340, 330) == rounded(kModelEdgeColour));
    CHECK(overlay.at<cv::Vec3b>(168, 330) == green);
    CHECK(overlay.at<cv::Vec3b>(200, 391) == green);
    CHECK(overlay.at<cv::Vec3b>(240, 380) == cv::Vec3b(0, 0, 255));
    CHECK(overlay.at<cv::Vec3b>(300, 320) == cv::Vec3b(0, 255, 0));
  }
  for (const Verdict verdict : {Verdict::unknown, Verdict::none}) {
    const cv::Mat overlay = drawn_as(verdict);
    CHECK(overlay.at<cv::Vec3b>(300, 420) == cv::Vec3b(0, 0, 0));
    CHECK(overlay.at<cv::Vec3b>(240, 380) == green);
  }
  const cv::Rect caption(100, 120, 300, 25);
  const cv::Mat match = drawn_as(Verdict::match), ambiguous = drawn_as(Verdict::ambiguous);
  CHECK(cv::norm(match(caption), ambiguous(caption), cv::NORM_L1) > 0);
}

TEST_CASE("Edges that are seen are where the lens shows them, and no others") {
  CameraModel bent = kCamera;
  bent.k1 = -0.3;
  bent.p1 = 0.01;
  const ObjectModel model = cube();
  double length_px = 0;
  for (const PictureLine& line : edges_seen(model, kStraightAhead, bent, 640, 480)) {
    Point2d last{};
    for (std::size_t k = 0; k < line.size(); ++k) {
      const Point2d p = bent.straight(line[k]);
      const double x = std::abs(p.x - 319.5), y = std::abs(p.y - 239.5);
      CHECK(std::max(x, y) == Approx(100).margin(0.05));
      if (k > 0) length_px += std::hypot(p.x - last.x, p.y - last.y);
      last = p;
    }
  }
  // Rims may show a pixel or two of the edges that lead away from them.
  CHECK(length_px > 780);
  CHECK(length_px < 820);
  CHECK(edges_seen(model, {{}, {0, 0, -6}}, kCamera, 640, 480).empty());
  CHECK(edges_seen(model, {{}, {50, 0, 6}}, kCamera, 640, 480).empty());
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
