#include "runtime/vision/vision.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "tests/rounds.h"
#include "tests/runtime/vision/graph_bytes.h"
#include "tests/runtime/vision/pictures.h"

namespace aspect {
namespace {

cv::Mat three_blobs() {
  cv::Mat picture = cv::Mat::zeros(120, 200, CV_8UC3);
  picture(cv::Rect(10, 10, 20, 20)) = colour(0);
  picture(cv::Rect(50, 20, 60, 80)) = colour(1);
  picture(cv::Rect(70, 40, 20, 20)) = colour(2);
  picture(cv::Rect(140, 60, 40, 40)) = colour(3);
  return picture;
}

// Spans of a graph fit together: blobs own consecutive contours and relations among them.
void check_spans(const ViewGraph& graph) {
  int contours = 0, relations = 0;
  for (std::size_t k = 0; k < graph.blobs.size(); ++k) {
    const Blob& blob = graph.blobs[k];
    REQUIRE(blob.first_contour == contours);
    REQUIRE(blob.first_relation == relations);
    contours += blob.contour_count;
    relations += blob.relation_count;
    for (int i = blob.first_contour; i < contours; ++i)
      REQUIRE(graph.contours[static_cast<std::size_t>(i)].blob == k);
    for (int i = blob.first_relation; i < relations; ++i) {
      const Relation& r = graph.relations[static_cast<std::size_t>(i)];
      REQUIRE(r.from < blob.contour_count);
      REQUIRE(r.to < blob.contour_count);
      REQUIRE(r.from != r.to);
    }
  }
  REQUIRE(contours == static_cast<int>(graph.contours.size()));
  REQUIRE(relations == static_cast<int>(graph.relations.size()));
}

}  // namespace

TEST_CASE("a frame with padded rows equals the packed one") {
  std::mt19937 random(31);
  for (int round = 0; round < rounds(10); ++round) {
    const cv::Mat packed = polygon_picture(random, {150, 110}, 5);
    cv::Mat wide = noise_picture(random, {190, 110});
    packed.copyTo(wide(cv::Rect(0, 0, 150, 110)));
    OwnedVision vision(150, 110);
    const GraphBytes expected(vision.run(packed));
    REQUIRE(GraphBytes(vision.run(wide(cv::Rect(0, 0, 150, 110)))) == expected);
  }
}

TEST_CASE("rows may run upwards") {
  std::mt19937 random(32);
  const cv::Mat picture = polygon_picture(random, {150, 110}, 5);
  cv::Mat flipped;
  cv::flip(picture, flipped, 0);
  OwnedVision vision(150, 110);
  const GraphBytes expected(vision.run(picture));
  Frame frame = frame_of(flipped);
  frame.data += 109 * frame.stride_bytes;
  frame.stride_bytes = -frame.stride_bytes;
  REQUIRE(GraphBytes(vision.vision().run(frame, {})) == expected);
}

TEST_CASE("a frame with blue first equals the one with red first") {
  std::mt19937 random(33);
  for (int round = 0; round < rounds(10); ++round) {
    const cv::Mat picture = polygon_picture(random, {150, 110}, 5);
    cv::Mat swapped;
    cv::cvtColor(picture, swapped, cv::COLOR_RGB2BGR);
    OwnedVision vision(150, 110);
    const GraphBytes expected(vision.run(picture));
    Frame frame = frame_of(swapped);
    frame.format = PixelFormat::bgr8;
    REQUIRE(GraphBytes(vision.vision().run(frame, {})) == expected);
    frame.format = PixelFormat::rgb8;
    REQUIRE_FALSE(GraphBytes(vision.vision().run(frame, {})) == expected);
  }
}

TEST_CASE("a region of interest sees what is in it, where it is in the frame") {
  const cv::Mat picture = three_blobs();
  OwnedVision vision(200, 120);
  VisionParameters parameters;
  parameters.region_of_interest = {130, 50, 60, 60};
  const ViewGraph graph = vision.run(picture, parameters);
  REQUIRE(graph.contours.size() == 1);
  REQUIRE(graph.contours[0].box == Box{140, 60, 40, 40});
  cv::Mat alone = cv::Mat::zeros(picture.size(), CV_8UC3);
  const cv::Rect part(130, 50, 60, 60);
  picture(part).copyTo(alone(part));
  const GraphBytes in_part(graph);
  REQUIRE(in_part == GraphBytes(vision.run(alone)));
}

TEST_CASE("a region of interest cuts what reaches out of it") {
  const cv::Mat picture = three_blobs();
  OwnedVision vision(200, 120);
  VisionParameters parameters;
  parameters.region_of_interest = {150, 0, 50, 80};
  const ViewGraph graph = vision.run(picture, parameters);
  REQUIRE(graph.contours.size() == 1);
  REQUIRE(graph.contours[0].box == Box{150, 60, 30, 20});
}

TEST_CASE("a look at a part of a frame has its colours as a run, and no regions") {
  const cv::Mat picture = three_blobs();
  VisionParameters parameters;
  parameters.region_of_interest = {40, 10, 90, 100};
  OwnedVision runs(200, 120), looks(200, 120);
  runs.run(frame_of(picture), parameters);
  REQUIRE(looks.vision().look(frame_of(picture), parameters));
  CHECK(looks.vision().regions().regions.empty());
  const Planes &a = runs.vision().colours(), &b = looks.vision().colours();
  REQUIRE(a.active == b.active);
  for (int y = a.active.y; y < a.active.y + a.active.height; ++y)
    for (int x = a.active.x; x < a.active.x + a.active.width; ++x) {
      REQUIRE(a.red[a.place(x, y)] == b.red[b.place(x, y)]);
      REQUIRE(a.blue[a.place(x, y)] == b.blue[b.place(x, y)]);
    }
  parameters.region_of_interest = {0, 100, 30, 20};
  CHECK_FALSE(looks.vision().look(frame_of(picture), parameters));
}

TEST_CASE("frames without pixels, too large ones and black ones give an empty graph") {
  OwnedVision vision(64, 48);
  const cv::Mat black = cv::Mat::zeros(48, 64, CV_8UC3);
  const cv::Mat white(50, 70, CV_8UC3, cv::Scalar(255, 255, 255));
  const Frame frame = frame_of(white);
  for (const Frame& empty : {Frame{}, Frame{frame.data, 0, 10, 0}, Frame{frame.data, 10, 0, 30},
                             Frame{frame.data, -3, 10, 30}, Frame{frame.data, 10, -3, 30},
                             Frame{frame.data, 65, 10, frame.stride_bytes},
                             Frame{frame.data, 10, 49, frame.stride_bytes}, frame_of(black)}) {
    vision.run(white(cv::Rect(0, 0, 64, 48)));
    REQUIRE(vision.regions().regions.size() == 1);
    const ViewGraph graph = vision.vision().run(empty, {});
    REQUIRE(graph.contours.empty());
    REQUIRE(graph.relations.empty());
    REQUIRE(graph.blobs.empty());
    REQUIRE(graph.dropped_regions == 0);
    REQUIRE(vision.regions().regions.empty());
  }
}

TEST_CASE("a full white frame is one region and a single pixel is too small for one") {
  const cv::Mat white(48, 64, CV_8UC3, cv::Scalar(255, 255, 255));
  OwnedVision vision(64, 48);
  const ViewGraph graph = vision.run(white);
  REQUIRE(graph.contours.size() == 1);
  REQUIRE(graph.contours[0].area_px == 64 * 48);
  REQUIRE(graph.contours[0].box == Box{0, 0, 64, 48});
  REQUIRE(graph.contours[0].chain.size() == 2 * (63 + 47));
  REQUIRE(vision.run(white(cv::Rect(0, 0, 1, 1))).contours.empty());
  VisionParameters parameters;
  parameters.area_min_px = 1;
  parameters.thickness_min_px = 0;
  const ViewGraph pixel = vision.run(white(cv::Rect(0, 0, 1, 1)), parameters);
  REQUIRE(pixel.contours.size() == 1);
  REQUIRE(pixel.contours[0].area_px == 1);
  REQUIRE(pixel.contours[0].chain.empty());
}

TEST_CASE("blobs come by area with their own contours") {
  OwnedVision vision(200, 120);
  const ViewGraph graph = vision.run(three_blobs());
  check_spans(graph);
  REQUIRE(graph.blobs.size() == 3);
  REQUIRE(graph.blobs[0].box == Box{50, 20, 60, 80});
  REQUIRE(graph.blobs[1].box == Box{140, 60, 40, 40});
  REQUIRE(graph.blobs[2].box == Box{10, 10, 20, 20});
  // The largest: the surface, its hole and what fills it.
  REQUIRE(graph.blobs[0].contour_count == 3);
  REQUIRE(graph.blobs[0].relation_count == 6);
  REQUIRE(graph.blobs[1].contour_count == 1);
  REQUIRE(graph.blobs[2].contour_count == 1);
}

TEST_CASE("as one blob all pieces belong together") {
  OwnedVision vision(200, 120);
  VisionParameters parameters;
  parameters.one_blob = true;
  const ViewGraph graph = vision.run(three_blobs(), parameters);
  check_spans(graph);
  REQUIRE(graph.blobs.size() == 1);
  REQUIRE(graph.blobs[0].contour_count == 5);
  REQUIRE(graph.blobs[0].relation_count == 20);
  REQUIRE(graph.blobs[0].box == Box{10, 10, 170, 90});
  // The median of 3 x 3 takes the four corners of each piece.
  REQUIRE(graph.blobs[0].area_px == 400 + 4800 + 1600 - 3 * 4);
}

TEST_CASE("the same frame gives the same bytes again, whatever came between") {
  std::mt19937 random(34);
  OwnedVision vision(150, 110);
  for (int round = 0; round < rounds(20); ++round) {
    const cv::Mat picture =
        round % 2 == 0 ? polygon_picture(random, {150, 110}, 6) : noise_picture(random, {150, 110});
    const GraphBytes first(vision.run(picture));
    REQUIRE(GraphBytes(vision.run(picture)) == first);
    VisionParameters other;
    other.smooth = false;
    other.intensity_min = 0;
    vision.run(noise_picture(random, {150, 110}), other);
    vision.run(noise_picture(random, {40, 110}), other);
    REQUIRE(GraphBytes(vision.run(picture)) == first);
    OwnedVision fresh(150, 110);
    REQUIRE(GraphBytes(fresh.run(picture)) == first);
  }
}

TEST_CASE("Vision prepared for larger frames sees smaller ones as one made for them does") {
  std::mt19937 random(35);
  OwnedVision large(300, 200);
  for (int round = 0; round < rounds(10); ++round) {
    const cv::Mat picture = polygon_picture(random, {150, 110}, 6);
    OwnedVision fitting(150, 110);
    REQUIRE(GraphBytes(large.run(picture)) == GraphBytes(fitting.run(picture)));
  }
}

TEST_CASE("frames of noise of many sizes and parameters run clean") {
  std::mt19937 random(36);
  OwnedVision vision(140, 100);
  for (int round = 0; round < rounds(400); ++round) {
    const cv::Size size{1 + static_cast<int>(random() % 140), 1 + static_cast<int>(random() % 100)};
    cv::Mat picture = noise_picture(random, size);
    if (round % 3 == 0) cv::GaussianBlur(picture, picture, {}, 1 + round % 4);
    VisionParameters parameters;
    parameters.intensity_min = static_cast<int>(random() % 500);
    parameters.chroma_step = 1 + static_cast<int>(random() % 40);
    parameters.area_min_px = static_cast<int>(random() % 30);
    parameters.thickness_min_px = static_cast<float>(random() % 4);
    parameters.smooth = random() % 2 == 0;
    parameters.one_blob = random() % 2 == 0;
    parameters.relations_max = static_cast<int>(random() % 60);
    check_spans(vision.run(picture, parameters));
  }
}

TEST_CASE("the stages' times are there and a black frame takes none of the later ones") {
  OwnedVision vision(200, 120);
  vision.run(three_blobs());
  const VisionTimes times = vision.vision().times();
  REQUIRE(times.convert.count() > 0);
  REQUIRE(times.enhance.count() > 0);
  REQUIRE(times.segment.count() > 0);
  REQUIRE(times.features.count() > 0);
  vision.run(cv::Mat::zeros(120, 200, CV_8UC3));
  REQUIRE(vision.vision().times().segment.count() == 0);
}

}  // namespace aspect
