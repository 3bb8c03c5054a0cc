#include "tests/runtime/vision/pictures.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace aspect {
namespace {

// A number for each colour, 0 for black.
int colour_key(const cv::Mat& picture, int y, int x) {
  if (picture.type() == CV_8U) return picture.at<std::uint8_t>(y, x);
  const auto& pixel = picture.at<cv::Vec3b>(y, x);
  return (pixel[0] * 256 + pixel[1]) * 256 + pixel[2];
}

cv::Mat colour_keys(const cv::Mat& picture) {
  cv::Mat keys(picture.size(), CV_32S);
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x) keys.at<int>(y, x) = colour_key(picture, y, x);
  return keys;
}

void renumber_by_first_pixel(cv::Mat& labels) {
  std::map<int, int> number{{0, 0}};
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x) {
      int& label = labels.at<int>(y, x);
      label = number.try_emplace(label, static_cast<int>(number.size())).first->second;
    }
}

cv::Mat drawn_polygons(std::mt19937& random, cv::Size size, int count) {
  cv::Mat drawn = cv::Mat::zeros(size, CV_8UC3);
  std::uniform_int_distribution<int> x(-10, size.width + 10), y(-10, size.height + 10);
  for (int i = 0; i < count; ++i) {
    std::vector<cv::Point> corners;
    for (int k = 0; k < 3 + i % 3; ++k) corners.push_back(cv::Point{x(random), y(random)});
    cv::fillPoly(drawn, std::vector<std::vector<cv::Point>>{corners}, colour(i));
  }
  return drawn;
}

// Paints black what a square of 5 x 5 pixels of one colour does not fit into.
cv::Mat without_slivers(const cv::Mat& drawn) {
  const cv::Mat square = cv::getStructuringElement(cv::MORPH_RECT, {5, 5});
  cv::Mat picture = cv::Mat::zeros(drawn.size(), CV_8UC3);
  for (int i = 0; i < kColourCount; ++i) {
    cv::Mat mask;
    cv::inRange(drawn, colour(i), colour(i), mask);
    // Beyond the frame there is nothing that could complete a square.
    cv::copyMakeBorder(mask, mask, 5, 5, 5, 5, cv::BORDER_CONSTANT, 0);
    cv::morphologyEx(mask, mask, cv::MORPH_OPEN, square);
    picture.setTo(colour(i), mask(cv::Rect({5, 5}, drawn.size())));
  }
  return picture;
}

// Two pieces of a component that touch only by a strip thinner than three pixels are two to the
// segmentation: such pictures have no single right answer.
bool has_bridges(const cv::Mat& components) {
  double count = 0;
  cv::minMaxLoc(components, nullptr, &count);
  for (int label = 1; label <= static_cast<int>(count); ++label) {
    cv::Mat mask = mask_of(components, label), pieces;
    cv::copyMakeBorder(mask, mask, 1, 1, 1, 1, cv::BORDER_CONSTANT, 0);
    cv::erode(mask, mask, cv::getStructuringElement(cv::MORPH_RECT, {3, 3}));
    if (cv::connectedComponents(mask, pieces, 4) > 2) return true;
  }
  return false;
}

}  // namespace

std::size_t vision_bytes(int width_px, int height_px, SensorKind sensor) {
  Arena counting;
  Vision vision;
  vision.prepare(counting, width_px, height_px, sensor);
  return counting.used_bytes();
}

OwnedVision::OwnedVision(int width_px, int height_px, SensorKind sensor)
    : memory_(vision_bytes(width_px, height_px, sensor)) {
  Arena arena = memory_.arena();
  vision_.prepare(arena, width_px, height_px, sensor);
  arena.seal();
}

ViewGraph OwnedVision::run(const cv::Mat& picture, const VisionParameters& parameters) {
  return vision_.run(frame_of(picture), parameters);
}

VisionParameters exact_parameters() {
  VisionParameters parameters;
  parameters.smooth = false;
  parameters.intensity_step = 765;
  parameters.area_min_px = 24;
  parameters.thickness_min_px = 3;
  return parameters;
}

Frame frame_of(const cv::Mat& picture) {
  return {picture.data, picture.cols, picture.rows, static_cast<std::ptrdiff_t>(picture.step),
          PixelFormat::rgb8};
}

std::vector<double> areas_of(const cv::Mat& picture, const VisionParameters& parameters) {
  OwnedVision vision(picture.cols, picture.rows);
  vision.run(picture, parameters);
  std::vector<double> areas;
  for (const Region& region : vision.regions().regions) areas.push_back(region.sums.area);
  std::sort(areas.begin(), areas.end());
  return areas;
}

cv::Mat blurred(const cv::Mat& picture) {
  cv::Mat out;
  cv::GaussianBlur(picture, out, {}, 1.0);
  return out;
}

cv::Mat label_picture(const RegionMap& map, cv::Size size) {
  cv::Mat labels = cv::Mat::zeros(size, CV_32S);
  const Box& box = map.active;
  for (int y = box.y; y < box.y + box.height; ++y)
    for (int x = box.x; x < box.x + box.width; ++x)
      labels.at<int>(y, x) = map.labels[static_cast<std::size_t>(y * map.stride_px + x)];
  return labels;
}

cv::Mat mask_of(const cv::Mat& labels, int label) {
  return labels == label;
}

bool same_partition(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size()) return false;
  std::map<int, int> b_from_a{{0, 0}}, a_from_b{{0, 0}};
  for (int y = 0; y < a.rows; ++y)
    for (int x = 0; x < a.cols; ++x) {
      const int p = a.at<int>(y, x), q = b.at<int>(y, x);
      if (b_from_a.try_emplace(p, q).first->second != q) return false;
      if (a_from_b.try_emplace(q, p).first->second != p) return false;
    }
  return true;
}

double partition_difference(const cv::Mat& a, const cv::Mat& b) {
  std::map<int, std::map<int, int>> meetings;
  for (int y = 0; y < a.rows; ++y)
    for (int x = 0; x < a.cols; ++x) ++meetings[a.at<int>(y, x)][b.at<int>(y, x)];
  int astray = 0;
  for (const auto& [label, others] : meetings) {
    int all = 0, most = 0;
    for (const auto& [other, pixels] : others) {
      all += pixels;
      most = std::max(most, pixels);
    }
    astray += all - most;
  }
  return static_cast<double>(astray) / static_cast<double>(a.total());
}

cv::Mat equal_components(const cv::Mat& picture) {
  const cv::Mat keys = colour_keys(picture);
  std::map<int, bool> done{{0, true}};
  cv::Mat all = cv::Mat::zeros(picture.size(), CV_32S);
  int count = 0;
  for (int y = 0; y < keys.rows; ++y)
    for (int x = 0; x < keys.cols; ++x) {
      const int key = keys.at<int>(y, x);
      if (std::exchange(done[key], true)) continue;
      const cv::Mat mask = keys == key;
      cv::Mat own;
      const int own_count = cv::connectedComponents(mask, own, 4, CV_32S) - 1;
      own += count;
      own.copyTo(all, mask);
      count += own_count;
    }
  renumber_by_first_pixel(all);
  return all;
}

cv::Mat without_small(const cv::Mat& labels, int area_min_px) {
  std::map<int, int> area;
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x) ++area[labels.at<int>(y, x)];
  cv::Mat kept = labels.clone();
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (area[kept.at<int>(y, x)] < area_min_px) kept.at<int>(y, x) = 0;
  renumber_by_first_pixel(kept);
  return kept;
}

cv::Mat random_mask(std::mt19937& random, cv::Size size, double density) {
  std::bernoulli_distribution set(density);
  cv::Mat mask(size, CV_8U);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      mask.at<std::uint8_t>(y, x) = set(random) ? std::uint8_t{255} : std::uint8_t{0};
  return mask;
}

cv::Mat noise_picture(std::mt19937& random, cv::Size size) {
  cv::Mat picture(size, CV_8UC3);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      for (int channel = 0; channel < 3; ++channel)
        picture.at<cv::Vec3b>(y, x)[channel] = static_cast<std::uint8_t>(random());
  return picture;
}

cv::Scalar colour(int index) {
  static const std::array<cv::Scalar, kColourCount> colours = {
      cv::Scalar(200, 40, 40),   cv::Scalar(40, 180, 60),  cv::Scalar(50, 60, 220),
      cv::Scalar(220, 200, 30),  cv::Scalar(180, 40, 190), cv::Scalar(40, 170, 180),
      cv::Scalar(210, 210, 210), cv::Scalar(230, 120, 30)};
  return colours[static_cast<std::size_t>(index % kColourCount)];
}

cv::Mat polygon_picture(std::mt19937& random, cv::Size size, int count) {
  for (;;) {
    const cv::Mat picture = without_slivers(drawn_polygons(random, size, count));
    if (!has_bridges(equal_components(picture))) return picture;
  }
}

cv::Mat surface_picture(std::mt19937& random, cv::Size size) {
  cv::Mat picture = cv::Mat::zeros(size, CV_8UC3);
  const auto side = static_cast<double>(std::min(size.width, size.height));
  std::uniform_real_distribution<double> jitter(-0.04, 0.04), start(0, 2 * std::numbers::pi);
  const cv::Point2d centre{size.width / 2.0 + side * jitter(random),
                           size.height / 2.0 + side * jitter(random)};
  const int sectors = 3 + static_cast<int>(random() % 3);
  const double first = start(random), step = 2 * std::numbers::pi / sectors;
  const auto rim = [&](double angle) {
    return cv::Point(centre + 0.42 * side * cv::Point2d(std::cos(angle), std::sin(angle)));
  };
  for (int k = 0; k < sectors; ++k) {
    const double angle = first + k * step;
    const std::vector<cv::Point> corners = {cv::Point(centre), rim(angle), rim(angle + step / 2),
                                            rim(angle + step)};
    cv::fillPoly(picture, std::vector<std::vector<cv::Point>>{corners},
                 colour(k + static_cast<int>(first)));
  }
  return picture;
}

}  // namespace aspect
