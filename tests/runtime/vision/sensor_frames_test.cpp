// Grey and surface-id frames, and what stands for colour in all that are not in colour.
#include <catch2/catch.hpp>
#include <opencv2/imgproc.hpp>

#include "runtime/vision/feature.h"
#include "runtime/vision/sensor_colour.h"
#include "tests/runtime/vision/graph_bytes.h"
#include "tests/runtime/vision/pictures.h"

namespace aspect {
namespace {

Frame plain_frame(const cv::Mat& picture) {
  return {picture.data, picture.cols, picture.rows, static_cast<std::ptrdiff_t>(picture.step),
          picture.type() == CV_8UC1 ? PixelFormat::grey8 : PixelFormat::label16};
}

// Two rectangles side by side.
cv::Mat two_greys(int left, int right) {
  cv::Mat picture = cv::Mat::zeros(80, 120, CV_8UC1);
  picture(cv::Rect(10, 10, 50, 60)).setTo(left);
  picture(cv::Rect(60, 10, 50, 60)).setTo(right);
  return picture;
}

std::size_t grey_regions(const cv::Mat& picture) {
  OwnedVision vision(picture.cols, picture.rows, SensorKind::grey);
  vision.run(plain_frame(picture), default_parameters(SensorKind::grey));
  return vision.regions().regions.size();
}

}  // namespace

TEST_CASE("surfaces part where grey steps, and neither where it steps less nor where it drifts") {
  CHECK(grey_regions(two_greys(100, 120)) == 2);
  CHECK(grey_regions(two_greys(100, 104)) == 1);
  cv::Mat drifting = two_greys(0, 0);
  for (int x = 10; x < 110; ++x) drifting(cv::Rect(x, 10, 1, 60)).setTo(60 + x);
  CHECK(grey_regions(drifting) == 1);
}

TEST_CASE("noise of two grey levels neither parts nor joins") {
  std::mt19937 random(3);
  for (const int right : {100, 120}) {
    cv::Mat picture = two_greys(100, right);
    for (int y = 10; y < 70; ++y)
      for (int x = 10; x < 110; ++x)
        picture.at<std::uint8_t>(y, x) =
            static_cast<std::uint8_t>(picture.at<std::uint8_t>(y, x) + random() % 5 - 2);
    CHECK(grey_regions(picture) == (right == 100 ? 1 : 2));
  }
}

TEST_CASE("a grey frame is cut like the colour frame whose three channels it is") {
  std::mt19937 random(8);
  for (int k = 0; k < 30; ++k) {
    cv::Mat grey, colours;
    cv::cvtColor(polygon_picture(random, {140, 100}, 6), grey, cv::COLOR_RGB2GRAY);
    cv::cvtColor(grey, colours, cv::COLOR_GRAY2RGB);
    VisionParameters parameters = default_parameters(SensorKind::grey);
    parameters.smooth = k % 2 == 0;
    OwnedVision grey_vision(140, 100, SensorKind::grey), colour_vision(140, 100);
    const ViewGraph seen = grey_vision.run(plain_frame(grey), parameters);
    parameters.sensor = SensorKind::colour;
    const ViewGraph expected = colour_vision.run(colours, parameters);
    REQUIRE(expected.contours.size() > 1);
    CHECK(seen.contours.size() == expected.contours.size());
    CHECK(same_partition(label_picture(grey_vision.regions(), grey.size()),
                         label_picture(colour_vision.regions(), grey.size())));
  }
}

TEST_CASE("Y of a colour camera's frame is cut like the grey frame that it is") {
  std::mt19937 random(9);
  for (int k = 0; k < 10; ++k) {
    cv::Mat grey, chroma(50, 140, CV_8UC1);
    cv::cvtColor(polygon_picture(random, {140, 100}, 6), grey, cv::COLOR_RGB2GRAY);
    cv::randu(chroma, 0, 256);
    const Frame plain = plain_frame(grey);
    Frame frame = plain;
    frame.format = PixelFormat::nv12;
    frame.chroma = chroma.data;
    frame.chroma_stride_bytes = 140;
    frame.yuv.full_range = true;
    const VisionParameters parameters = default_parameters(SensorKind::grey);
    OwnedVision vision(140, 100, SensorKind::grey), expected(140, 100, SensorKind::grey);
    REQUIRE(expected.run(plain, parameters).contours.size() > 1);
    vision.run(frame, parameters);
    CHECK(same_partition(label_picture(vision.regions(), grey.size()),
                         label_picture(expected.regions(), grey.size())));
  }
}

TEST_CASE("twice the light changes no grey feature") {
  OwnedVision dark(120, 80, SensorKind::grey), bright(120, 80, SensorKind::grey);
  const cv::Mat a = two_greys(60, 100), b = two_greys(120, 200);
  const auto parameters = default_parameters(SensorKind::grey);
  const ViewGraph in_dark = dark.run(plain_frame(a), parameters);
  const ViewGraph in_light = bright.run(plain_frame(b), parameters);
  REQUIRE(in_dark.contours.size() == 2);
  REQUIRE(in_light.contours.size() == 2);
  for (std::size_t k = 0; k < 2; ++k)
    CHECK(feature_of(in_dark.contours[k], in_dark.blobs[0]).share ==
          feature_of(in_light.contours[k], in_light.blobs[0]).share);
  CHECK(feature_of(in_dark.contours[0], in_dark.blobs[0]).share[0] ==
        Approx(60 / 140.0).margin(1e-3));
}

TEST_CASE("surface ids are cut where they differ, in either byte, and nowhere else") {
  std::mt19937 random(9);
  for (int k = 0; k < 30; ++k) {
    const cv::Mat polygons = polygon_picture(random, {140, 100}, 6);
    const cv::Mat truth = equal_components(polygons);
    cv::Mat ids = cv::Mat::zeros(truth.size(), CV_16UC1);
    // The same low byte for all, or the same high byte.
    for (int y = 0; y < ids.rows; ++y)
      for (int x = 0; x < ids.cols; ++x)
        if (const int label = truth.at<int>(y, x); label != 0)
          ids.at<std::uint16_t>(y, x) =
              static_cast<std::uint16_t>(k % 2 == 0 ? label : 256 * label + 7);
    VisionParameters parameters = exact_parameters();
    parameters.sensor = SensorKind::surface;
    OwnedVision vision(140, 100, SensorKind::surface);
    vision.run(plain_frame(ids), parameters);
    CHECK(same_partition(label_picture(vision.regions(), ids.size()), without_small(truth, 24)));
  }
}

TEST_CASE("the colours of the first surfaces are far apart, and each id's are its own") {
  std::vector<Contour> contours(40);
  for (std::size_t k = 0; k < contours.size(); ++k)
    contours[k].mean_rgb = {static_cast<float>(k + 1), 0, 0};
  colour_by_surface(contours);
  for (std::size_t a = 0; a < contours.size(); ++a) {
    const auto& colour = contours[a].mean_rgb;
    CHECK(colour[0] + colour[1] + colour[2] == 255);
    for (std::size_t b = 0; b < a; ++b) {
      float most = 0;
      for (std::size_t c = 0; c < 3; ++c)
        most = std::max(most, std::abs(colour[c] - contours[b].mean_rgb[c]));
      CHECK(most >= 13);  // a step of a share, as matching counts them, is 0.05
    }
  }
}

}  // namespace aspect
