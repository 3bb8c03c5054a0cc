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
constexpr std::uint32_t kSeed = 20260101;

float squared_distance(const TypeAttributes& a, const TypeAttributes& b) {
  float sum = 0;
  for (std::size_t d = 0; d < kTypeDimensions; ++d) sum += (a[d] - b[d]) * (a[d] - b[d]);
  return sum;
}

std::vector<TypeAttributes> thinned(std::span<const TypeAttributes> samples) {
  const std::size_t step = (samples.size() + kMostSamples - 1) / kMostSamples;
  std::vector<TypeAttributes> kept;
  for (std::size_t i = 0; i < samples.size(); i += std::max<std::size_t>(step, 1))
    kept.push_back(samples[i]);
  return kept;
}

// Each next start is drawn with a chance proportional to its squared distance from those before.
std::vector<TypeAttributes> starts(const std::vector<TypeAttributes>& samples, std::size_t count) {
  std::mt19937 random(kSeed);
  std::vector<TypeAttributes> types{samples.front()};
  std::vector<float> distance(samples.size(), std::numeric_limits<float>::infinity());
  while (types.size() < count) {
    double total = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      distance[i] = std::min(distance[i], squared_distance(samples[i], types.back()));
      total += static_cast<double>(distance[i]);
    }
    if (!(total > 0)) break;
    double target = total * (static_cast<double>(random()) / 4294967296.0);
    std::size_t chosen = samples.size() - 1;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      target -= static_cast<double>(distance[i]);
      if (target >= 0 || !(distance[i] > 0)) continue;
      chosen = i;
      break;
    }
    if (!(distance[chosen] > 0)) break;
    types.push_back(samples[chosen]);
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

}  // namespace

std::uint16_t nearest_type(std::span<const TypeAttributes> types, const TypeAttributes& sample) {
  std::uint16_t best = 0;
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t k = 0; k < types.size(); ++k) {
    const float distance = squared_distance(types[k], sample);
    if (distance >= least) continue;
    least = distance;
    best = static_cast<std::uint16_t>(k);
  }
  return best;
}

std::vector<TypeAttributes> find_contour_types(std::span<const TypeAttributes> all,
                                               std::size_t count) {
  if (all.empty() || count == 0) return {};
  const std::vector<TypeAttributes> samples = thinned(all);
  std::vector<TypeAttributes> types = starts(samples, count);
  std::vector<std::uint16_t> type_of(samples.size(), 0), before;
  for (int round = 0; round < kMostRounds && type_of != before; ++round) {
    before = type_of;
    tbb::parallel_for(std::size_t{0}, samples.size(), [&](std::size_t i) {
      type_of[i] = nearest_type(types, samples[i]);
    });
    move_to_means(samples, type_of, types);
  }
  return types;
}

}  // namespace aspect
