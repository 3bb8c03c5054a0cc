#include "tools/eval/reliability.h"

#include <algorithm>
#include <cmath>

namespace aspect {
namespace {

// A bin holds its lower bound; the last one 1 as well.
std::size_t bin_of(double probability) {
  constexpr auto kBins = static_cast<double>(kReliabilityBins);
  return static_cast<std::size_t>(std::clamp(std::floor(probability * kBins), 0.0, kBins - 1));
}

void count_verdict(const JudgedView& view, Reliability& reliability) {
  switch (view.verdict) {
    case Verdict::none:
      ++reliability.not_judged;
      break;
    case Verdict::match:
      ++reliability.matches;
      reliability.right_matches += view.right ? 1U : 0U;
      break;
    case Verdict::ambiguous:
      ++reliability.ambiguous;
      break;
    case Verdict::unknown:
      ++reliability.unknown;
      break;
  }
}

}  // namespace

std::optional<double> Reliability::right_match_share() const {
  if (matches == 0) return std::nullopt;
  return static_cast<double>(right_matches) / static_cast<double>(matches);
}

std::optional<double> Reliability::expected_calibration_error() const {
  if (judged() == 0) return std::nullopt;
  double sum = 0;
  for (const ReliabilityBin& bin : bins)
    sum += static_cast<double>(bin.count) * std::abs(bin.mean_probability - bin.right_share);
  return sum / static_cast<double>(judged());
}

Reliability reliability_of(std::span<const JudgedView> views) {
  Reliability reliability;
  for (const JudgedView& view : views) {
    count_verdict(view, reliability);
    if (view.verdict == Verdict::none) continue;
    ReliabilityBin& bin = reliability.bins[bin_of(view.probability)];
    ++bin.count;
    bin.mean_probability += view.probability;
    bin.right_share += view.right ? 1 : 0;
  }
  for (ReliabilityBin& bin : reliability.bins) {
    if (bin.count == 0) continue;
    bin.mean_probability /= static_cast<double>(bin.count);
    bin.right_share /= static_cast<double>(bin.count);
  }
  return reliability;
}

}  // namespace aspect
