#include "tools/calibrate/segmentation/region_match.h"

#include <algorithm>
#include <map>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "tools/calibrate/object/surface_map.h"

namespace aspect {

WantedAreas wanted_areas(const cv::Mat& picture, const cv::Mat& paints) {
  constexpr int kLeast_px = 80;
  constexpr float kLeastHalfWidth_px = 3;
  WantedAreas wanted{picture, cv::Mat(paints.size(), CV_32S, cv::Scalar(0)), {}};
  const cv::Mat distance = distance_to_border(paints);
  double most = 0;
  cv::minMaxLoc(paints, nullptr, &most);
  for (int paint = 0; paint <= static_cast<int>(most); ++paint) {
    cv::Mat labels;
    const int count = cv::connectedComponents(paints == paint, labels, 4);
    for (int label = 1; label < count; ++label) {
      const cv::Mat mask = labels == label;
      double half_width = 0;
      cv::minMaxLoc(distance, nullptr, &half_width, nullptr, nullptr, mask);
      const int area = cv::countNonZero(mask);
      if (area < kLeast_px || half_width < double{kLeastHalfWidth_px}) continue;
      wanted.area_px.push_back(area);
      wanted.areas.setTo(cv::Scalar(static_cast<double>(wanted.area_px.size())), mask);
    }
  }
  return wanted;
}

double RegionMatch::score(const WantedAreas& wanted, const VisionParameters& parameters) {
  const cv::Mat& picture = wanted.picture;
  if (picture.cols > vision_.max_width_px() || picture.rows > vision_.max_height_px())
    memory_.plan([&](Arena& arena) {
      vision_.prepare(arena, std::max(picture.cols, vision_.max_width_px()),
                      std::max(picture.rows, vision_.max_height_px()));
    });
  vision_.run({picture.data, picture.cols, picture.rows, static_cast<std::ptrdiff_t>(picture.step),
               PixelFormat::bgr8},
              parameters);
  const RegionMap& map = vision_.regions();
  std::map<std::pair<int, int>, int> shared_px;  // by area and region
  for (const Run& run : map.runs) {
    if (run.label == 0) continue;
    const int* row = wanted.areas.ptr<int>(run.row);
    for (int x = run.begin; x < run.end; ++x)
      if (row[x] != 0) ++shared_px[{row[x], run.label}];
  }
  std::vector<double> best(wanted.area_px.size(), 0);
  for (const auto& [pair, pixels] : shared_px) {
    const auto area = static_cast<std::size_t>(pair.first - 1);
    const int region_px =
        static_cast<int>(map.regions[static_cast<std::size_t>(pair.second - 1)].sums.area);
    const double together = wanted.area_px[area] + region_px - pixels;
    best[area] = std::max(best[area], pixels / together);
  }
  double sum = 0;
  for (const double share : best) sum += share;
  return best.empty() ? 0 : sum / static_cast<double>(best.size());
}

}  // namespace aspect
