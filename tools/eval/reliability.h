// Whether verdicts and probabilities can be believed (Guo et al., On calibration of modern neural
// networks, 2017).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "runtime/recognition/verdict.h"

namespace aspect {

struct JudgedView {
  Verdict verdict = Verdict::none;
  double probability = 0;
  bool right = false;  // the best hypothesis names the object that is there
};

// Views of about the same probability.
struct ReliabilityBin {
  std::size_t count = 0;
  double mean_probability = 0, right_share = 0;
};

inline constexpr std::size_t kReliabilityBins = 10;  // equal parts of 0 to 1

struct Reliability {
  std::size_t matches = 0, ambiguous = 0, unknown = 0;
  std::size_t not_judged = 0;  // nothing was found, or no pose was looked for: not in the bins
  std::size_t right_matches = 0;
  std::array<ReliabilityBin, kReliabilityBins> bins{};

  std::size_t judged() const { return matches + ambiguous + unknown; }
  // Nothing where there is no match.
  std::optional<double> right_match_share() const;
  // Mean distance of the bins' probability and share, weighted by their views; nothing where no
  // view was judged.
  std::optional<double> expected_calibration_error() const;
};

Reliability reliability_of(std::span<const JudgedView> views);

}  // namespace aspect
