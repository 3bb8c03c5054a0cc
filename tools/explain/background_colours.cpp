#include "tools/explain/background_colours.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>

#include "runtime/recognition/scene_starts.h"
#include "runtime/recognition/seen_colours.h"

namespace aspect {
namespace {

using Shares = std::array<float, 3>;

// Of a picture: every pixel's shares of r, g and b, or none of any where it is dark.
std::vector<Shares> shares_of(const cv::Mat& rgb, int intensity_min) {
  std::vector<Shares> shares;
  shares.reserve(rgb.total());
  for (int y = 0; y < rgb.rows; ++y)
    for (int x = 0; x < rgb.cols; ++x) {
      const auto& pixel = rgb.at<cv::Vec3b>(y, x);
      const int sum = pixel[0] + pixel[1] + pixel[2];
      const float times = sum > 0 && sum >= intensity_min ? 1 / static_cast<float>(sum) : 0;
      shares.push_back({static_cast<float>(pixel[0]) * times, static_cast<float>(pixel[1]) * times,
                        static_cast<float>(pixel[2]) * times});
    }
  return shares;
}

bool has_region(const cv::Mat& mask) {
  cv::Mat labels, statistics, centres;
  const int count = cv::connectedComponentsWithStats(mask, labels, statistics, centres, 4);
  for (int k = 1; k < count; ++k)
    if (statistics.at<int>(k, cv::CC_STAT_AREA) >=
        kLeastRegionShare * static_cast<double>(mask.total()))
      return true;
  return false;
}

struct SeenColour {
  std::size_t pixels = 0;
  bool has_region = false;
};

std::vector<SeenColour> seen_in(const cv::Mat& rgb, std::span<const Shares> colours,
                                int intensity_min) {
  const std::vector<Shares> shares = shares_of(rgb, intensity_min);
  std::vector<SeenColour> seen;
  cv::Mat mask(rgb.size(), CV_8U);
  for (const Shares& colour : colours) {
    std::size_t pixels = 0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      const bool is_near = squared_distance(shares[k], colour) < kColourReach * kColourReach;
      mask.data[k] = is_near ? 255 : 0;
      pixels += is_near ? 1U : 0U;
    }
    const bool may_be =
        static_cast<double>(pixels) >= kLeastRegionShare * static_cast<double>(shares.size());
    seen.push_back({pixels, may_be && has_region(mask)});
  }
  return seen;
}

}  // namespace

std::vector<ColourPresence> presence_of(std::span<const Eigen::Vector3d> colours,
                                        std::span<const cv::Mat> pictures, int intensity_min) {
  std::vector<Shares> wanted;
  for (const Eigen::Vector3d& colour : colours) {
    const Eigen::Vector3f share = (colour / std::max(1e-9, colour.sum())).cast<float>();
    wanted.push_back({share.x(), share.y(), share.z()});
  }
  std::vector<std::vector<SeenColour>> seen(pictures.size());
  tbb::parallel_for(std::size_t{0}, pictures.size(),
                    [&](std::size_t k) { seen[k] = seen_in(pictures[k], wanted, intensity_min); });
  std::size_t all = 0;
  for (const cv::Mat& picture : pictures) all += picture.total();
  std::vector<ColourPresence> presence(colours.size());
  for (std::size_t c = 0; c < colours.size(); ++c) {
    std::size_t pixels = 0, with_region = 0;
    for (const auto& picture : seen) {
      pixels += picture[c].pixels;
      with_region += picture[c].has_region ? 1U : 0U;
    }
    if (pictures.empty()) continue;
    presence[c] = {static_cast<double>(pixels) / static_cast<double>(all),
                   static_cast<double>(with_region) / static_cast<double>(pictures.size())};
  }
  return presence;
}

}  // namespace aspect
