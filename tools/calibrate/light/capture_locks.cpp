// Idea: of two frames of a camera that stands still, most pixels that are not the object show the
// same thing, and their ratios pile up at one value: 1 where nothing changed. Where the camera
// moved there is no such pile, and nothing is said. Weak side: a light that somebody switched on
// looks like an exposure that changed; for colours it is as bad.
#include "tools/calibrate/light/capture_locks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace aspect {
namespace {

constexpr int kDarkest = 24, kLightest = 245;  // outside of these a ratio says nothing

// Where the values pile up; nothing where they do not.
std::optional<double> pile_of(std::vector<double>& values) {
  constexpr double kWidth = 0.02, kLeastShare = 0.45;
  std::sort(values.begin(), values.end());
  std::size_t best = 0, best_first = 0, last = 0;
  for (std::size_t first = 0; first < values.size(); ++first) {
    while (last < values.size() && values[last] - values[first] <= 2 * kWidth) ++last;
    if (last - first > best) {
      best = last - first;
      best_first = first;
    }
  }
  if (static_cast<double>(best) < kLeastShare * static_cast<double>(values.size()))
    return std::nullopt;
  return values[best_first + best / 2];
}

}  // namespace

std::optional<Eigen::Vector3d> gain_between(const cv::Mat& from, const cv::Mat& to) {
  constexpr double kLeastShare = 0.05;  // of the picture
  if (from.size() != to.size() || from.empty()) return std::nullopt;
  std::array<std::vector<double>, 3> ratios;
  for (int y = 0; y < from.rows; ++y)
    for (int x = 0; x < from.cols; ++x) {
      const auto& a = from.at<cv::Vec3b>(y, x);
      const auto& b = to.at<cv::Vec3b>(y, x);
      const auto [low, high] = std::minmax({a[0], a[1], a[2], b[0], b[1], b[2]});
      if (low < kDarkest || high > kLightest) continue;
      for (int channel = 0; channel < 3; ++channel)
        ratios[static_cast<std::size_t>(2 - channel)].push_back(
            std::log(static_cast<double>(b[channel]) / a[channel]));
    }
  if (static_cast<double>(ratios[0].size()) < kLeastShare * static_cast<double>(from.total()))
    return std::nullopt;
  Eigen::Vector3d gain;
  for (int channel = 0; channel < 3; ++channel) {
    const auto pile = pile_of(ratios[static_cast<std::size_t>(channel)]);
    if (!pile) return std::nullopt;
    gain[channel] = *pile;
  }
  return gain;
}

std::string white_balance_warning(double factor, const std::string& one, const std::string& other) {
  return fmt::format(
      "white balance is not locked: red against blue changes by {:.0f} % between {} and {}; set "
      "white_balance_automatic = 0 and white_balance_temperature in [camera.controls]",
      100 * (factor - 1), one, other);
}

std::vector<std::string> lock_warnings(const std::vector<cv::Mat>& pictures,
                                       const std::vector<std::string>& names) {
  constexpr double kBalance = 0.04, kExposure = 0.05;
  double balance = 0, exposure = 0;
  std::size_t balance_at = 0, exposure_at = 0;
  for (std::size_t k = 1; k < pictures.size(); ++k) {
    const auto gain = gain_between(pictures.front(), pictures[k]);
    if (!gain) continue;
    const double turned =
        std::max({std::abs((*gain)[0] - (*gain)[2]), std::abs((*gain)[0] - (*gain)[1]),
                  std::abs((*gain)[1] - (*gain)[2])});
    if (turned > balance) balance = turned, balance_at = k;
    if (std::abs(gain->mean()) > std::abs(exposure)) exposure = gain->mean(), exposure_at = k;
  }
  std::vector<std::string> warnings;
  if (balance > kBalance)
    warnings.push_back(white_balance_warning(std::exp(balance), names.front(), names[balance_at]));
  if (std::abs(exposure) > kExposure)
    warnings.push_back(fmt::format(
        "exposure is not locked: what stands still is {:.0f} % {} in {} than in {}; set "
        "auto_exposure = 1 (manual), exposure_time_absolute and gain_automatic = 0 in "
        "[camera.controls]",
        100 * (std::exp(std::abs(exposure)) - 1), exposure > 0 ? "brighter" : "darker",
        names[exposure_at], names.front()));
  return warnings;
}

}  // namespace aspect
