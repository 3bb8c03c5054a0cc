// Idea: what differs between two frames of the same is noise, twice; within a frame, what is left
// of a flat place by a mask that cancels planes and slopes (Immerkaer, Fast noise variance
// estimation, 1996) is noise, 36 times. Values are gathered by brightness; the least of the places
// within a frame are taken, since texture only adds. A line is laid through the variances, weighted
// by how well each is known. Weak side: within frames fine texture everywhere is taken for noise,
// and JPEG, which flattens noise, for less.
#include "tools/calibrate/light/noise_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace aspect {
namespace {

constexpr int kBins = 32, kBinWidth = 256 / kBins;
constexpr double kDarkest = 8, kLightest = 250;  // beyond, values are cut off and noise with them
constexpr std::size_t kLeastPixels = 400;
constexpr std::size_t kLightBin = 3;  // what is darker is background

// Of differences: what lies beyond three deviations is something that moved.
double clipped_variance(const std::vector<float>& differences) {
  constexpr double kClip = 3, kKept = 0.9733;  // of a normal distribution's variance
  std::vector<float> sizes(differences);
  for (float& size : sizes) size = std::abs(size);
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  double deviation = std::max(1.5 * double{*middle}, 0.75);
  double variance = deviation * deviation;
  for (int round = 0; round < 6; ++round) {
    double sum = 0;
    std::size_t count = 0;
    for (const float d : differences)
      if (std::abs(double{d}) <= kClip * deviation) sum += double{d} * double{d}, ++count;
    if (count == 0) break;
    variance = sum / static_cast<double>(count) / kKept;
    deviation = std::sqrt(std::max(variance, 0.01));
  }
  return variance;
}

using Differences = std::array<std::vector<float>, kBins>;

// Brightness by brightness, since a dark background may stand still while all else moves. False
// where nothing does.
bool add_differences(const cv::Mat& a, const cv::Mat& b, Differences& bins) {
  constexpr float kStill = 24;  // grey values: noise of 12 keeps within it for four pixels of five
  constexpr double kLeastStill = 0.7;
  if (a.size() != b.size()) return false;
  Differences own;
  for (int y = 0; y < a.rows; ++y)
    for (int x = 0; x < a.cols; ++x)
      for (int c = 0; c < 3; ++c) {
        const int u = a.at<cv::Vec3b>(y, x)[c], v = b.at<cv::Vec3b>(y, x)[c];
        if (std::min(u, v) < kDarkest || std::max(u, v) > kLightest) continue;
        own[static_cast<std::size_t>((u + v) / 2 / kBinWidth)].push_back(static_cast<float>(v - u));
      }
  std::vector<std::size_t> still_bins;
  std::size_t light = 0, light_and_still = 0;
  for (std::size_t bin = 0; bin < own.size(); ++bin) {
    const auto still = std::count_if(own[bin].begin(), own[bin].end(),
                                     [](float d) { return std::abs(d) <= kStill; });
    const bool is_still =
        own[bin].size() >= kLeastPixels &&
        static_cast<double>(still) >= kLeastStill * static_cast<double>(own[bin].size());
    if (is_still) still_bins.push_back(bin);
    if (bin < kLightBin) continue;
    light += own[bin].size();
    light_and_still += is_still ? own[bin].size() : 0;
  }
  if (light == 0 || 2 * light_and_still < light) return false;
  for (const std::size_t bin : still_bins)
    bins[bin].insert(bins[bin].end(), own[bin].begin(), own[bin].end());
  return true;
}

// Without those near black and white, where large differences are missing: one of the two would be
// cut off.
std::vector<NoisePoint> points_of(const Differences& bins) {
  constexpr double kReach = 3;  // deviations
  std::vector<NoisePoint> points;
  for (std::size_t bin = 0; bin < bins.size(); ++bin) {
    if (bins[bin].size() < kLeastPixels) continue;
    const double value = (static_cast<double>(bin) + 0.5) * kBinWidth,
                 variance = clipped_variance(bins[bin]) / 2;
    const double room = 2 * std::min(value - kDarkest, kLightest - value);
    if (room > kReach * std::sqrt(2 * variance))
      points.push_back({value, variance, bins[bin].size()});
  }
  return points;
}

struct Place {
  double value = 0, variance = 0;
};

void add_places(const cv::Mat& picture, std::vector<Place>& places) {
  constexpr int kSide = 8;
  constexpr double kMaskSum = 36;
  const cv::Mat mask = (cv::Mat_<float>(3, 3) << 1, -2, 1, -2, 4, -2, 1, -2, 1);
  std::vector<cv::Mat> channels;
  cv::split(picture, channels);
  for (const cv::Mat& channel : channels) {
    cv::Mat rest;
    cv::filter2D(channel, rest, CV_32F, mask, {-1, -1}, 0, cv::BORDER_REFLECT);
    for (int y = 0; y + kSide <= channel.rows; y += kSide)
      for (int x = 0; x + kSide <= channel.cols; x += kSide) {
        const cv::Rect place(x, y, kSide, kSide);
        double least = 0, most = 0;
        cv::minMaxLoc(channel(place), &least, &most);
        if (least < kDarkest || most > kLightest) continue;
        const double root = cv::norm(rest(place));
        places.push_back({cv::mean(channel(place))[0], root * root / kMaskSum / (kSide * kSide)});
      }
  }
}

// The quiet places' variance is that of the quietest ones, corrected for being so: of 64 values
// whose masks overlap, three tenths of the places come out below this share of the truth (measured
// on normal noise).
std::vector<NoisePoint> points_of(std::vector<Place> places) {
  constexpr double kQuantile = 0.3, kShareAtQuantile = 0.81;
  constexpr std::size_t kLeastPlaces = 12;
  std::array<std::vector<double>, kBins> bins;
  for (const Place& place : places)
    bins[static_cast<std::size_t>(place.value / kBinWidth)].push_back(place.variance);
  std::vector<NoisePoint> points;
  for (std::size_t bin = 0; bin < bins.size(); ++bin) {
    std::vector<double>& values = bins[bin];
    if (values.size() < kLeastPlaces) continue;
    const auto at = values.begin() +
                    static_cast<std::ptrdiff_t>(kQuantile * static_cast<double>(values.size()));
    std::nth_element(values.begin(), at, values.end());
    points.push_back(
        {(static_cast<double>(bin) + 0.5) * kBinWidth, *at / kShareAtQuantile, values.size() * 64});
  }
  return points;
}

// Least squares; a variance is known to a share of itself, the better the more pixels.
NoiseModel line_through(const std::vector<NoisePoint>& points) {
  const auto fitted = [&](bool with_constant, bool with_slope) {
    double s0 = 0, s1 = 0, s2 = 0, t0 = 0, t1 = 0;
    for (const NoisePoint& p : points) {
      const double weight = static_cast<double>(std::min<std::size_t>(p.pixels, 20000)) /
                            std::pow(p.variance + 0.1, 2);
      s0 += weight;
      s1 += weight * p.value;
      s2 += weight * p.value * p.value;
      t0 += weight * p.variance;
      t1 += weight * p.variance * p.value;
    }
    if (!with_slope) return NoiseModel{t0 / s0, 0};
    if (!with_constant) return NoiseModel{0, t1 / s2};
    const double determinant = s0 * s2 - s1 * s1;
    if (determinant <= 1e-12 * s0 * s2) return NoiseModel{t0 / s0, 0};
    return NoiseModel{(s2 * t0 - s1 * t1) / determinant, (s0 * t1 - s1 * t0) / determinant};
  };
  const NoiseModel line = fitted(true, true);
  if (line.per_grey < 0) return fitted(true, false);
  return line.constant < 0 ? fitted(false, true) : line;
}

// Differences across the borders of blocks are larger than others there.
bool has_blocks(const cv::Mat& picture) {
  constexpr double kLarger = 1.15;
  cv::Mat grey;
  cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
  double at_borders = 0, elsewhere = 0;
  std::size_t borders = 0, others = 0;
  for (int y = 0; y < grey.rows; ++y)
    for (int x = 1; x < grey.cols; ++x) {
      const int step = std::abs(grey.at<std::uint8_t>(y, x) - grey.at<std::uint8_t>(y, x - 1));
      if (step > 12) continue;
      if (x % 8 == 0)
        at_borders += step, ++borders;
      else
        elsewhere += step, ++others;
    }
  return borders > 0 && others > 0 &&
         at_borders / static_cast<double>(borders) >
             kLarger * elsewhere / static_cast<double>(others);
}

}  // namespace

double NoiseModel::deviation(double value) const {
  return std::sqrt(std::max(0.0, constant + per_grey * value));
}

Result<MeasuredNoise> measure_noise(const std::vector<cv::Mat>& pictures) {
  MeasuredNoise measured;
  Differences bins;
  for (std::size_t k = 1; k < pictures.size(); ++k)
    measured.pairs += add_differences(pictures[k - 1], pictures[k], bins);
  if (measured.pairs > 0) measured.points = points_of(bins);
  if (measured.points.empty()) {
    measured.pairs = 0;
    std::vector<Place> places;
    for (const cv::Mat& picture : pictures) {
      add_places(picture, places);
      measured.is_compressed |= has_blocks(picture);
    }
    measured.points = points_of(std::move(places));
  }
  if (measured.points.empty())
    return Error{
        "nothing in the frames is flat, and neither dark nor cut off; take a sheet of paper in "
        "half light, twice without moving"};
  measured.model = line_through(measured.points);
  return measured;
}

// Of two pixels side by side of a flat place, one pair in ten thousand has shares that differ by
// more than kReach * 255 / (r + g + b) * deviation of a channel: 1.7 after the 3 x 3 median, whose
// results overlap, and 5 without it (measured on normal noise of 1.5 to 6 grey values, at sums of
// 50 to 360).
int noise_steps_for(const NoiseModel& model, const VisionParameters& vision) {
  constexpr double kSmoothReach = 1.7, kPlainReach = 5;
  constexpr int kMostSum = 765, kStride = 3, kMostSteps = 255;
  const double reach = vision.smooth ? kSmoothReach : kPlainReach;
  double needed = 0;
  for (int sum = std::max(vision.intensity_min, kStride); sum <= kMostSum; sum += kStride)
    needed =
        std::max(needed, reach * model.deviation(sum / 3.0) - vision.chroma_step * sum / 255.0);
  return static_cast<int>(std::min<double>(std::ceil(needed - 0.05), kMostSteps));
}

}  // namespace aspect
