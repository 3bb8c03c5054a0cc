// Pictures for the tests of vision, drawn with OpenCV, and what they are compared by.
#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <random>
#include <vector>

#include "runtime/base/arena.h"
#include "runtime/vision/vision.h"

namespace aspect {

// An arena with storage of its own.
class OwnedArena {
 public:
  explicit OwnedArena(std::size_t bytes) : lines_((bytes + 63) / 64) {}
  Arena arena() { return Arena(std::as_writable_bytes(std::span(lines_))); }

 private:
  struct alignas(64) CacheLine {
    std::array<std::byte, 64> bytes;
  };
  std::vector<CacheLine> lines_;
};

std::size_t vision_bytes(int width_px, int height_px, SensorKind sensor = SensorKind::colour);

// Vision with memory of its own.
class OwnedVision {
 public:
  OwnedVision(int width_px, int height_px, SensorKind sensor = SensorKind::colour);
  // `picture`: 8 bits, 3 channels, red first.
  ViewGraph run(const cv::Mat& picture, const VisionParameters& parameters = {});
  ViewGraph run(const Frame& frame, const VisionParameters& parameters) {
    return vision_.run(frame, parameters);
  }
  Vision& vision() { return vision_; }
  const RegionMap& regions() const { return vision_.regions(); }

 private:
  OwnedArena memory_;
  Vision vision_;
};

// No median, and small things kept: every pixel of a flat picture has one right label.
VisionParameters exact_parameters();

Frame frame_of(const cv::Mat& picture);

// Areas of its regions, the smallest first.
std::vector<double> areas_of(const cv::Mat& picture, const VisionParameters& parameters);

// By a lens that is a little out of focus.
cv::Mat blurred(const cv::Mat& picture);

// Labels of the whole frame, 0 outside the active part: type CV_32S.
cv::Mat label_picture(const RegionMap& map, cv::Size size);

// 255 where `labels` (CV_32S) is `label`.
cv::Mat mask_of(const cv::Mat& labels, int label);

// Labels are the same up to renumbering, and 0 stays 0.
bool same_partition(const cv::Mat& a, const cv::Mat& b);

// Share of the pixels of `a` that are not where most of their label are in `b`.
double partition_difference(const cv::Mat& a, const cv::Mat& b);

// The 4-connected components of equal colour (type CV_8UC3, black is background) or of equal
// values (CV_8U, 0 is background), numbered from 1 in the order of their first pixels.
cv::Mat equal_components(const cv::Mat& picture);

// Forgets labels with fewer pixels; the rest keep their order.
cv::Mat without_small(const cv::Mat& labels, int area_min_px);

cv::Mat random_mask(std::mt19937& random, cv::Size size, double density);

cv::Mat noise_picture(std::mt19937& random, cv::Size size);

// Colours whose shares differ by far more than any tolerance; even values, so that half of them
// is exact.
inline constexpr int kColourCount = 8;
cv::Scalar colour(int index);

// Polygons of flat colours over one another on black, without antialiasing, without anything that
// a square of 5 x 5 pixels does not fit into, and without narrow bridges: the components of equal
// colour are the only right segmentation of it.
cv::Mat polygon_picture(std::mt19937& random, cv::Size size, int count);

// A few large convex pieces that touch each other, for blur and noise.
cv::Mat surface_picture(std::mt19937& random, cv::Size size);

}  // namespace aspect
