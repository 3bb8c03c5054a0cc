#include "tools/calibrate/segmentation/segmentation_search.h"

#include <array>
#include <cmath>
#include <span>

namespace aspect {
namespace {

struct SearchedKey {
  const char* name;
  int VisionParameters::*value;
  std::span<const int> candidates;
};

constexpr std::array kIntensityMin = {16, 24, 32, 40, 48, 60, 75, 90, 110, 130};
constexpr std::array kChromaStep = {4, 5, 6, 7, 8, 10, 12, 14, 17, 20};
constexpr std::array kNoiseSteps = {0, 1, 2, 3, 4, 5, 6, 8, 10};
constexpr std::array kIntensityStep = {0, 15, 20, 30, 45, 60, 90, 765};

const std::array<SearchedKey, 4>& searched_keys() {
  static const std::array<SearchedKey, 4> kKeys = {
      {{"intensity_min", &VisionParameters::intensity_min, kIntensityMin},
       {"chroma_step", &VisionParameters::chroma_step, kChromaStep},
       {"noise_steps", &VisionParameters::noise_steps, kNoiseSteps},
       {"intensity_step", &VisionParameters::intensity_step, kIntensityStep}}};
  return kKeys;
}

double mean_score(RegionMatch& match, const std::vector<WantedAreas>& frames,
                  const VisionParameters& parameters) {
  double sum = 0;
  for (const WantedAreas& frame : frames) sum += match.score(frame, parameters);
  return frames.empty() ? 0 : sum / static_cast<double>(frames.size());
}

}  // namespace

SearchedValues search_values(const std::vector<WantedAreas>& frames,
                             const VisionParameters& start) {
  constexpr double kTrifle = 0.002;
  constexpr int kMostRounds = 4;
  RegionMatch match;
  SearchedValues found{start, 0, 0};
  found.score_before = found.score_after = mean_score(match, frames, start);
  for (int round = 0; round < kMostRounds; ++round) {
    bool moved = false;
    for (const SearchedKey& key : searched_keys()) {
      VisionParameters tried = found.parameters, best = found.parameters;
      double best_score = found.score_after + kTrifle;
      for (const int value : key.candidates) {
        tried.*key.value = value;
        const double score = mean_score(match, frames, tried);
        if (score <= best_score) continue;
        best_score = score;
        best = tried;
        moved = true;
        found.score_after = score;
      }
      found.parameters = best;
    }
    if (!moved) break;
  }
  return found;
}

HeldOut compare_values(const std::vector<WantedAreas>& frames, const VisionParameters& before,
                       const VisionParameters& after) {
  constexpr double kTrifle = 0.01, kErrors = 2;
  constexpr std::size_t kLeastFrames = 3;
  RegionMatch match;
  HeldOut held_out;
  double squares = 0;
  const auto count = static_cast<double>(frames.size());
  for (const WantedAreas& frame : frames) {
    const double a = match.score(frame, before), b = match.score(frame, after);
    held_out.score_before += a / count;
    held_out.score_after += b / count;
    squares += (b - a) * (b - a);
  }
  if (frames.size() < kLeastFrames) return held_out;
  held_out.gain = held_out.score_after - held_out.score_before;
  const double variance = (squares - count * held_out.gain * held_out.gain) / (count - 1);
  held_out.gain_error = std::sqrt(std::max(0.0, variance) / count);
  held_out.is_better = held_out.gain > kTrifle && held_out.gain > kErrors * held_out.gain_error;
  return held_out;
}

std::vector<std::pair<std::string, int>> changed_values(const VisionParameters& before,
                                                        const VisionParameters& after) {
  std::vector<std::pair<std::string, int>> changed;
  for (const SearchedKey& key : searched_keys())
    if (before.*key.value != after.*key.value) changed.emplace_back(key.name, after.*key.value);
  return changed;
}

}  // namespace aspect
