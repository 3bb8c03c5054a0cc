// Idea: inside the drawn area of a surface, away from its borders, a frame shows nothing but the
// surface. The median of the shares of its pixels is the surface's: shading changes no share, noise
// is as often above as below, and highlights are few.
#include "tools/calibrate/colours/surface_colours.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace aspect {
namespace {

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Weighted {
  double value = 0, weight = 0;
};

// The value with half of the weight on either side.
double weighted_median(std::vector<Weighted>& values) {
  std::sort(values.begin(), values.end(),
            [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
  double all = 0, below = 0;
  for (const Weighted& one : values) all += one.weight;
  for (const Weighted& one : values) {
    below += one.weight;
    if (2 * below >= all) return one.value;
  }
  return values.back().value;
}

// Of a frame's word on a surface: black level and noise are the larger a part of its shares the
// darker it is, and pixels of a frame share the frame's faults.
double weight_of(const PaintSample& sample) {
  return std::sqrt(static_cast<double>(sample.pixels.size())) * sample.brightness *
         sample.brightness;
}

Eigen::Vector3d rgb_at(const cv::Mat& picture, const cv::Point& p) {
  const auto& pixel = picture.at<cv::Vec3b>(p);
  return {static_cast<double>(pixel[2]), static_cast<double>(pixel[1]),
          static_cast<double>(pixel[0])};
}

// Shares that add up to 1 again.
Eigen::Vector3d median_share(const cv::Mat& picture, const std::vector<cv::Point>& pixels) {
  Eigen::Vector3d share;
  for (int channel = 0; channel < 3; ++channel) {
    std::vector<double> values;
    for (const cv::Point& p : pixels) values.push_back(shares_of(rgb_at(picture, p))[channel]);
    share[channel] = median(values);
  }
  return shares_of(share);
}

// Fills in what pixels say; false where they are too few.
bool measure(const cv::Mat& picture, const std::vector<cv::Point>& all,
             const SamplingParameters& parameters, PaintSample& sample) {
  std::size_t cut_off = 0;
  std::vector<double> brightness;
  for (const cv::Point& p : all) {
    const Eigen::Vector3d rgb = rgb_at(picture, p);
    cut_off += rgb.maxCoeff() >= parameters.lightest;
    if (rgb.maxCoeff() >= parameters.lightest || rgb.sum() < parameters.darkest_sum) continue;
    sample.pixels.push_back(p);
    brightness.push_back(rgb.mean());
  }
  if (sample.pixels.size() < parameters.least_pixels) return false;
  sample.share = median_share(picture, sample.pixels);
  sample.brightness = median(brightness);
  sample.cut_off_share = static_cast<double>(cut_off) / static_cast<double>(all.size());
  return true;
}

struct SharePair {
  Eigen::Vector3d before, after;
};

// The gain of each channel, up to a common factor, that takes the shares before to those after,
// each pair with a factor of its own: least squares of logarithms, which are as exact as their
// shares are large. What the pairs do not say stays 1.
Eigen::Vector3d light_gain(const std::vector<SharePair>& pairs) {
  constexpr double kLeastShare = 0.02, kHold = 1e-3;
  const auto count = static_cast<Eigen::Index>(pairs.size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(3 + count, 3 + count);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(3 + count);
  for (Eigen::Index k = 0; k < 3 + count; ++k) normal(k, k) = k < 3 ? kHold : 1e-9;
  for (Eigen::Index p = 0; p < count; ++p)
    for (Eigen::Index channel = 0; channel < 3; ++channel) {
      const SharePair& pair = pairs[static_cast<std::size_t>(p)];
      const double least = std::min(pair.before[channel], pair.after[channel]);
      if (least < kLeastShare) continue;
      const double weight = least * least,
                   ratio = std::log(pair.after[channel] / pair.before[channel]);
      normal(channel, channel) += weight;
      normal(3 + p, 3 + p) += weight;
      normal(channel, 3 + p) += weight;
      normal(3 + p, channel) += weight;
      right(channel) += weight * ratio;
      right(3 + p) += weight * ratio;
    }
  const Eigen::VectorXd solution = normal.ldlt().solve(right);
  return solution.head<3>().array().exp();
}

}  // namespace

std::vector<PaintSample> sample_paints(const cv::Mat& picture, const cv::Mat& paints,
                                       std::size_t paint_count, std::size_t frame,
                                       const SamplingParameters& parameters) {
  const cv::Mat distance = distance_to_border(paints);
  std::vector<std::vector<cv::Point>> inner(paint_count);
  for (int y = 0; y < paints.rows; ++y)
    for (int x = 0; x < paints.cols; ++x) {
      const int paint = paints.at<std::int16_t>(y, x);
      if (paint >= 0 && double{distance.at<float>(y, x)} > parameters.rim_px)
        inner[static_cast<std::size_t>(paint)].emplace_back(x, y);
    }
  std::vector<PaintSample> samples;
  for (std::size_t paint = 0; paint < paint_count; ++paint) {
    PaintSample sample;
    sample.paint = static_cast<int>(paint);
    sample.frame = frame;
    if (measure(picture, inner[paint], parameters, sample)) samples.push_back(std::move(sample));
  }
  return samples;
}

std::optional<PaintSample> sample_at(const cv::Mat& picture, cv::Point place, int paint,
                                     std::size_t frame, const SamplingParameters& parameters) {
  constexpr int kReach_px = 40, kSeed_px = 2, kRim_px = 2;
  constexpr double kAlike = 0.04;  // of a share: what noise and a surface's own spread leave
  const cv::Rect inside(0, 0, picture.cols, picture.rows);
  if (!inside.contains(place)) return std::nullopt;
  std::vector<cv::Point> seed;
  for (int y = -kSeed_px; y <= kSeed_px; ++y)
    for (int x = -kSeed_px; x <= kSeed_px; ++x)
      if (const cv::Point p = place + cv::Point(x, y); inside.contains(p)) seed.push_back(p);
  const Eigen::Vector3d wanted = median_share(picture, seed);
  const cv::Rect around =
      cv::Rect(place.x - kReach_px, place.y - kReach_px, 2 * kReach_px + 1, 2 * kReach_px + 1) &
      inside;
  cv::Mat alike(around.size(), CV_8U, cv::Scalar(0)), labels;
  for (int y = 0; y < alike.rows; ++y)
    for (int x = 0; x < alike.cols; ++x) {
      const Eigen::Vector3d rgb = rgb_at(picture, cv::Point(x, y) + around.tl());
      if ((shares_of(rgb) - wanted).cwiseAbs().maxCoeff() < kAlike)
        alike.at<std::uint8_t>(y, x) = 255;
    }
  for (const cv::Point& p : seed) alike.at<std::uint8_t>(p - around.tl()) = 255;
  cv::connectedComponents(alike, labels, 4);
  const int label = labels.at<int>(place - around.tl());
  cv::Mat piece = labels == label, eroded;
  cv::erode(piece, eroded, cv::Mat::ones(2 * kRim_px + 1, 2 * kRim_px + 1, CV_8U));
  std::vector<cv::Point> pixels;
  cv::findNonZero(eroded, pixels);
  for (cv::Point& p : pixels) p += around.tl();
  PaintSample sample;
  sample.paint = paint;
  sample.frame = frame;
  SamplingParameters few = parameters;
  few.least_pixels = 9;
  if (pixels.size() < parameters.least_pixels) pixels = seed;
  if (!measure(picture, pixels, few, sample)) return std::nullopt;
  return sample;
}

std::vector<PaintColour> paint_colours(const std::vector<PaintSample>& samples,
                                       std::size_t paint_count) {
  std::vector<PaintColour> colours(paint_count);
  for (std::size_t paint = 0; paint < paint_count; ++paint) {
    PaintColour& colour = colours[paint];
    std::vector<double> cut_off, distances;
    std::vector<Weighted> brightness;
    std::array<std::vector<Weighted>, 3> shares;
    for (const PaintSample& sample : samples) {
      if (sample.paint != static_cast<int>(paint)) continue;
      ++colour.frames;
      colour.pixels += sample.pixels.size();
      brightness.push_back({sample.brightness, weight_of(sample)});
      cut_off.push_back(sample.cut_off_share);
      for (int channel = 0; channel < 3; ++channel)
        shares[static_cast<std::size_t>(channel)].push_back(
            {sample.share[channel], weight_of(sample)});
    }
    if (colour.frames == 0) continue;
    Eigen::Vector3d share;
    for (int channel = 0; channel < 3; ++channel)
      share[channel] = weighted_median(shares[static_cast<std::size_t>(channel)]);
    colour.share = shares_of(share);
    colour.brightness = weighted_median(brightness);
    colour.cut_off_share = median(cut_off);
    for (const PaintSample& sample : samples)
      if (sample.paint == static_cast<int>(paint))
        distances.push_back((sample.share - colour.share).cwiseAbs().maxCoeff());
    colour.spread = median(distances);
  }
  return colours;
}

std::vector<double> light_changes(const std::vector<PaintSample>& samples,
                                  const std::vector<PaintColour>& colours, std::size_t frames) {
  std::vector<double> changes(frames, 1);
  for (std::size_t frame = 0; frame < frames; ++frame) {
    std::vector<SharePair> pairs;
    for (const PaintSample& sample : samples)
      if (sample.frame == frame)
        pairs.push_back({colours[static_cast<std::size_t>(sample.paint)].share, sample.share});
    const Eigen::Vector3d gain = light_gain(pairs).array().log();
    changes[frame] = std::exp(gain.maxCoeff() - gain.minCoeff());
  }
  return changes;
}

void add_unseen(const std::vector<Paint>& paints, std::vector<PaintColour>& colours) {
  constexpr std::size_t kLeast = 2;  // one surface says little of the light
  std::vector<SharePair> pairs;
  for (std::size_t p = 0; p < paints.size(); ++p)
    if (colours[p].frames > 0 && !paints[p].is_background)
      pairs.push_back({shares_of(paints[p].shown), colours[p].share});
  if (pairs.size() < kLeast) return;
  const Eigen::Vector3d gain = light_gain(pairs);
  for (std::size_t p = 0; p < paints.size(); ++p) {
    if (colours[p].frames > 0 || paints[p].textured || paints[p].is_background) continue;
    colours[p].share = shares_of(shares_of(paints[p].shown).cwiseProduct(gain));
    colours[p].is_estimate = true;
  }
}

}  // namespace aspect
