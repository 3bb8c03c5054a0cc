#include "compiler/index/contour_types.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>

namespace aspect {
namespace {

constexpr std::size_t kMostSamples = 200000;
constexpr int kMostRounds = 30;
// The best of several attempts: a single one ends up to 19 % above the best of OpenCV's five.
constexpr int kAttempts = 4;
constexpr std::size_t kTrials = 4;  // for each start
constexpr std::uint32_t kSeed = 20260101;

// One of each `step` neighbours, at random: views list their contours in a like order, and every
// step-th sample would be the same contour again and again.
std::vector<TypeAttributes> thinned(std::span<const TypeAttributes> samples) {
  const std::size_t step = (samples.size() + kMostSamples - 1) / kMostSamples;
  if (step <= 1) return {samples.begin(), samples.end()};
  std::mt19937 random(kSeed);
  std::vector<TypeAttributes> kept;
  for (std::size_t i = 0; i < samples.size(); i += step)
    kept.push_back(samples[i + random() % std::min(step, samples.size() - i)]);
  return kept;
}

using Distances = std::vector<float>;  // squared, from every sample to the nearest start

double sum_of(const Distances& distances) {
  double sum = 0;
  for (const float distance : distances) sum += static_cast<double>(distance);
  return sum;
}

// A sample, drawn with a chance proportional to its squared distance; `total` is their sum.
std::size_t draw(const Distances& distances, double total, std::mt19937& random) {
  double target = total * (static_cast<double>(random()) / 4294967296.0);
  std::size_t last = 0;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (!(distances[i] > 0)) continue;
    last = i;
    target -= static_cast<double>(distances[i]);
    if (target < 0) break;
  }
  return last;
}

// What the distances are with one start more.
Distances with_start(const std::vector<TypeAttributes>& samples, const Distances& nearest,
                     const TypeAttributes& start) {
  Distances nearer(nearest.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
    nearer[i] = std::min(nearest[i], squared_type_distance(samples[i], start));
  return nearer;
}

// Each next start is the best of a few that are drawn with a chance proportional to their squared
// distance from those before.
std::vector<TypeAttributes> starts(const std::vector<TypeAttributes>& samples, std::size_t count,
                                   std::mt19937& random) {
  std::vector<TypeAttributes> types{samples[random() % samples.size()]};
  Distances nearest = with_start(
      samples, Distances(samples.size(), std::numeric_limits<float>::infinity()), types.back());
  while (types.size() < count) {
    const double total = sum_of(nearest);
    if (!(total > 0)) break;
    std::array<std::size_t, kTrials> drawn{};
    std::array<Distances, kTrials> nearer;
    std::array<double, kTrials> left{};
    for (std::size_t& sample : drawn) sample = draw(nearest, total, random);
    tbb::parallel_for(std::size_t{0}, kTrials, [&](std::size_t k) {
      nearer[k] = with_start(samples, nearest, samples[drawn[k]]);
      left[k] = sum_of(nearer[k]);
    });
    const auto best =
        static_cast<std::size_t>(std::min_element(left.begin(), left.end()) - left.begin());
    types.push_back(samples[drawn[best]]);
    nearest = std::move(nearer[best]);
  }
  return types;
}

void move_to_means(const std::vector<TypeAttributes>& samples,
                   const std::vector<std::uint16_t>& type_of, std::vector<TypeAttributes>& types) {
  std::vector<std::array<double, kTypeDimensions>> sums(types.size());
  std::vector<std::size_t> counts(types.size(), 0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ++counts[type_of[i]];
    for (std::size_t d = 0; d < kTypeDimensions; ++d)
      sums[type_of[i]][d] += static_cast<double>(samples[i][d]);
  }
  for (std::size_t k = 0; k < types.size(); ++k)
    for (std::size_t d = 0; d < kTypeDimensions && counts[k] > 0; ++d)
      types[k][d] = static_cast<float>(sums[k][d] / static_cast<double>(counts[k]));
}

struct Attempt {
  std::vector<TypeAttributes> types;
  double scatter = std::numeric_limits<double>::infinity();  // sum of the squared distances
};

// Lloyd's rounds.
Attempt attempt(const std::vector<TypeAttributes>& samples, std::vector<TypeAttributes> types) {
  std::vector<std::uint16_t> type_of(samples.size(), 0), before;
  for (int round = 0; round < kMostRounds && type_of != before; ++round) {
    before = type_of;
    tbb::parallel_for(std::size_t{0}, samples.size(),
                      [&](std::size_t i) { type_of[i] = nearest_type(types, samples[i]); });
    move_to_means(samples, type_of, types);
  }
  double scatter = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
    scatter += static_cast<double>(squared_type_distance(samples[i], types[type_of[i]]));
  return {std::move(types), scatter};
}

}  // namespace

std::vector<TypeAttributes> find_contour_types(std::span<const TypeAttributes> all,
                                               std::size_t count) {
  if (all.empty() || count == 0) return {};
  const std::vector<TypeAttributes> samples = thinned(all);
  std::mt19937 random(kSeed);
  Attempt best;
  for (int k = 0; k < kAttempts; ++k) {
    Attempt next = attempt(samples, starts(samples, count, random));
    if (next.scatter < best.scatter) best = std::move(next);
  }
  return std::move(best.types);
}

}  // namespace aspect
