// Pictures of flat colours have one right answer, the connected components of equal colour; what
// blur, noise and mirrors may change of it is small.
#include "runtime/vision/segment.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "tests/rounds.h"
#include "tests/runtime/vision/pictures.h"

namespace aspect {
namespace {

constexpr int kSize_px = 160;

VisionParameters with_median() {
  VisionParameters parameters = exact_parameters();
  parameters.smooth = true;
  return parameters;
}

cv::Mat labels_of(const cv::Mat& picture, const VisionParameters& parameters) {
  // Noise has more runs than a picture of its size is expected to have.
  OwnedVision vision(picture.cols, 3 * picture.rows);
  vision.run(picture, parameters);
  REQUIRE(vision.regions().dropped_regions == 0);
  return label_picture(vision.regions(), picture.size());
}

std::vector<cv::Mat> polygon_pictures(unsigned seed, int count) {
  std::mt19937 random(seed);
  std::vector<cv::Mat> pictures;
  for (int i = 0; i < count; ++i)
    pictures.push_back(polygon_picture(random, {kSize_px, kSize_px - 30}, 3 + i % 6));
  return pictures;
}

constexpr int kTranspose = 2;

// `way`: of cv::flip, or kTranspose.
cv::Mat mirrored(const cv::Mat& picture, int way) {
  cv::Mat out;
  if (way == kTranspose)
    cv::transpose(picture, out);
  else
    cv::flip(picture, out, way);
  return out;
}

}  // namespace

TEST_CASE("regions of flat polygons are the components of equal colour, exact to the pixel") {
  for (const cv::Mat& picture : polygon_pictures(6, rounds(60))) {
    const cv::Mat expected = equal_components(picture);
    REQUIRE(partition_difference(labels_of(picture, exact_parameters()), expected) == 0);
    REQUIRE(same_partition(labels_of(picture, exact_parameters()), expected));
  }
}

TEST_CASE("labels are in the order of first pixels and areas, boxes and runs agree with them") {
  for (const cv::Mat& picture : polygon_pictures(7, rounds(10))) {
    OwnedVision vision(picture.cols, picture.rows);
    vision.run(picture, exact_parameters());
    const RegionMap& map = vision.regions();
    const cv::Mat labels = label_picture(map, picture.size());
    cv::Mat from_runs = cv::Mat::zeros(picture.size(), CV_32S);
    for (const Run& run : map.runs)
      from_runs(cv::Range(run.row, run.row + 1), cv::Range(run.begin, run.end)) = run.label;
    REQUIRE(cv::countNonZero(from_runs != labels) == 0);
    REQUIRE(cv::countNonZero(without_small(labels, 0) != labels) == 0);
    for (std::size_t k = 0; k < map.regions.size(); ++k) {
      const cv::Mat mask = mask_of(labels, static_cast<int>(k) + 1);
      const cv::Rect box = cv::boundingRect(mask);
      REQUIRE(map.regions[k].sums.area == cv::countNonZero(mask));
      REQUIRE(map.regions[k].box == Box{box.x, box.y, box.width, box.height});
      const cv::Scalar mean = cv::mean(picture, mask);
      for (int channel = 0; channel < 3; ++channel)
        REQUIRE(map.regions[k].mean_rgb[static_cast<std::size_t>(channel)] ==
                Approx(mean[channel]).margin(1e-3));
    }
  }
}

TEST_CASE("the median only rounds corners") {
  for (const cv::Mat& picture : polygon_pictures(8, rounds(20))) {
    const cv::Mat plain = labels_of(picture, exact_parameters()),
                  smooth = labels_of(picture, with_median());
    REQUIRE(partition_difference(plain, smooth) < 0.01);
  }
}

TEST_CASE("only foreground is labelled, whatever the picture") {
  std::mt19937 random(9);
  for (int round = 0; round < 30; ++round) {
    cv::Mat picture = noise_picture(random, {90, 60});
    cv::GaussianBlur(picture, picture, {}, round % 5 + 0.5);
    VisionParameters parameters = exact_parameters();
    parameters.intensity_min = 300 + static_cast<int>(random() % 120);
    const cv::Mat labels = labels_of(picture, parameters);
    for (int y = 0; y < picture.rows; ++y)
      for (int x = 0; x < picture.cols; ++x) {
        const auto& pixel = picture.at<cv::Vec3b>(y, x);
        if (labels.at<int>(y, x) != 0)
          REQUIRE(pixel[0] + pixel[1] + pixel[2] >= parameters.intensity_min);
      }
  }
}

TEST_CASE("every region is one 4-connected piece") {
  std::mt19937 random(10);
  for (int round = 0; round < 30; ++round) {
    cv::Mat picture = noise_picture(random, {90, 60});
    cv::GaussianBlur(picture, picture, {}, round % 4 + 0.5);
    VisionParameters parameters = with_median();
    parameters.area_min_px = 4;
    parameters.thickness_min_px = 0;
    const cv::Mat labels = labels_of(picture, parameters);
    double count = 0;
    cv::minMaxLoc(labels, nullptr, &count);
    for (int label = 1; label <= static_cast<int>(count); ++label) {
      cv::Mat pieces;
      REQUIRE(cv::connectedComponents(mask_of(labels, label), pieces, 4) == 2);
    }
  }
}

TEST_CASE("mirrored and transposed pictures give mirrored and transposed regions") {
  for (const cv::Mat& flat : polygon_pictures(11, rounds(20))) {
    for (const int way : {-1, 0, 1, kTranspose}) {
      const cv::Mat labels = labels_of(flat, exact_parameters());
      REQUIRE(same_partition(mirrored(labels, way),
                             labels_of(mirrored(flat, way), exact_parameters())));
      // A mixed pixel that is as near to one colour as to another goes to the lower label.
      for (const cv::Mat& mixed : {flat, blurred(flat)}) {
        const cv::Mat expected = mirrored(labels_of(mixed, with_median()), way);
        const cv::Mat found = labels_of(mirrored(mixed, way), with_median());
        REQUIRE(partition_difference(expected, found) < 0.001);
        REQUIRE(partition_difference(found, expected) < 0.001);
      }
    }
  }
}

TEST_CASE("half the brightness leaves the regions as they are") {
  for (const cv::Mat& picture : polygon_pictures(12, rounds(20))) {
    const cv::Mat half = picture / 2;
    REQUIRE(same_partition(labels_of(picture, with_median()), labels_of(half, with_median())));
  }
}

TEST_CASE("filaments and small regions vanish and leave nothing behind") {
  cv::Mat picture = cv::Mat::zeros(120, 200, CV_8UC3);
  picture(cv::Rect(20, 20, 60, 60)) = colour(0);
  picture(cv::Rect(100, 10, 90, 1)) = colour(1);
  picture(cv::Rect(100, 20, 90, 2)) = colour(2);
  picture(cv::Rect(100, 40, 4, 4)) = colour(3);
  cv::line(picture, {100, 60}, {190, 110}, colour(4), 1);
  picture(cv::Rect(40, 40, 3, 3)) = colour(1);
  for (const VisionParameters& parameters : {with_median(), exact_parameters()}) {
    const std::vector<double> areas = areas_of(picture, parameters);
    REQUIRE(areas.size() == 1);
    // The spot inside goes to the square or stays unlabelled, depending on its core.
    REQUIRE(areas[0] == Approx(3600).margin(9));
  }
}

TEST_CASE("a region of the least area is kept and one pixel less is not") {
  for (const int height : {5, 6}) {
    cv::Mat picture = cv::Mat::zeros(40, 40, CV_8UC3);
    picture(cv::Rect(10, 10, 6, height)) = colour(2);
    VisionParameters parameters = exact_parameters();
    parameters.area_min_px = 36;
    REQUIRE(areas_of(picture, parameters).size() == (height == 6 ? 1U : 0U));
    parameters.area_min_px = 30;
    REQUIRE(areas_of(picture, parameters).size() == 1);
  }
}

TEST_CASE("one colour at two brightnesses is one region, and two with an intensity step") {
  cv::Mat picture = cv::Mat::zeros(80, 120, CV_8UC3);
  picture(cv::Rect(10, 10, 50, 60)) = cv::Scalar(200, 100, 60);
  picture(cv::Rect(60, 10, 50, 60)) = cv::Scalar(100, 50, 30);
  REQUIRE(areas_of(picture, with_median()) == std::vector<double>{6000 - 4 * 1});
  VisionParameters parameters = exact_parameters();
  REQUIRE(areas_of(picture, parameters) == std::vector<double>{6000});
  parameters.intensity_step = 60;
  REQUIRE(areas_of(picture, parameters) == std::vector<double>{3000, 3000});
  parameters.intensity_step = 230;
  REQUIRE(areas_of(picture, parameters) == std::vector<double>{6000});
}

TEST_CASE("dark gaps part surfaces of one colour, sharp or blurred") {
  for (const double sigma : {0.0, 0.8, 1.6}) {
    cv::Mat picture = cv::Mat::zeros(120, 120, CV_8UC3);
    picture.setTo(cv::Scalar(24, 18, 18));
    for (int k = 0; k < 9; ++k)
      picture(cv::Rect(8 + 36 * (k % 3), 8 + 36 * (k / 3), 30, 30)) = cv::Scalar(180, 30, 25);
    if (sigma > 0) cv::GaussianBlur(picture, picture, {}, sigma);
    const std::vector<double> areas = areas_of(picture, {});
    CHECK(std::count_if(areas.begin(), areas.end(),
                        [](double area) { return area > 700 && area < 1100; }) == 9);
  }
}

TEST_CASE("faces of one colour in different light are parted, however much noise there is") {
  std::mt19937 random(31);
  for (const int most : {0, 4, 9}) {
    cv::Mat picture = cv::Mat::zeros(80, 140, CV_8UC3);
    picture(cv::Rect(10, 10, 60, 60)) = cv::Scalar(40, 160, 50);
    picture(cv::Rect(70, 10, 60, 60)) = cv::Scalar(28, 112, 35);
    for (auto p = picture.begin<cv::Vec3b>(); p != picture.end<cv::Vec3b>(); ++p)
      for (int c = 0; c < 3; ++c) {
        const int noise = static_cast<int>(random() % static_cast<unsigned>(2 * most + 1)) - most;
        (*p)[c] = cv::saturate_cast<std::uint8_t>((*p)[c] + noise);
      }
    const std::vector<double> areas = areas_of(picture, {});
    REQUIRE(areas.size() == 2);
    for (const double area : areas) CHECK(area == Approx(3600).epsilon(0.05));
  }
}

TEST_CASE("a smooth shading across a surface does not break it up") {
  cv::Mat picture = cv::Mat::zeros(100, 200, CV_8UC3);
  for (int x = 10; x < 190; ++x) {
    const double level = 0.35 + 0.65 * (x - 10) / 180.0;
    picture(cv::Rect(x, 10, 1, 80)) = level * cv::Scalar(220, 140, 60);
  }
  REQUIRE(areas_of(picture, with_median()).size() == 1);
  REQUIRE(areas_of(picture, {}).size() == 1);
}

TEST_CASE("blobs are the components of foreground that hold a region, largest first") {
  std::mt19937 random(14);
  for (const cv::Mat& picture : polygon_pictures(15, rounds(15))) {
    OwnedVision vision(picture.cols, picture.rows);
    vision.run(picture, exact_parameters());
    const RegionMap& map = vision.regions();
    cv::Mat grey, labels, stats, centres;
    cv::transform(picture, grey, cv::Matx13f(1, 1, 1));
    const int count = cv::connectedComponentsWithStats(grey > 0, labels, stats, centres, 4, CV_32S);
    REQUIRE(static_cast<int>(map.blobs.size()) == count - 1);
    const cv::Mat regions = label_picture(map, picture.size());
    for (std::size_t k = 0; k < map.blobs.size(); ++k) {
      const Blob& blob = map.blobs[k];
      if (k > 0) REQUIRE(blob.area_px <= map.blobs[k - 1].area_px);
      int own = 0;
      for (int y = 0; y < labels.rows && own == 0; ++y)
        for (int x = 0; x < labels.cols && own == 0; ++x) {
          const int region = regions.at<int>(y, x);
          if (region != 0 &&
              map.regions[static_cast<std::size_t>(region - 1)].blob == static_cast<int>(k))
            own = labels.at<int>(y, x);
        }
      REQUIRE(blob.area_px == static_cast<float>(stats.at<int>(own, cv::CC_STAT_AREA)));
      REQUIRE(blob.box ==
              Box{stats.at<int>(own, cv::CC_STAT_LEFT), stats.at<int>(own, cv::CC_STAT_TOP),
                  stats.at<int>(own, cv::CC_STAT_WIDTH), stats.at<int>(own, cv::CC_STAT_HEIGHT)});
      REQUIRE(blob.centre_px.x == Approx(centres.at<double>(own, 0)).epsilon(1e-5));
      REQUIRE(blob.centre_px.y == Approx(centres.at<double>(own, 1)).epsilon(1e-5));
    }
  }
}

}  // namespace aspect
