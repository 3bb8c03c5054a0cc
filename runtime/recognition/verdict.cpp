#include "runtime/recognition/verdict.h"

#include <algorithm>

#include "runtime/base/portable_math.h"

namespace aspect {
namespace {

// Explains as well: agreement that is no farther below the best one's.
constexpr double kAsWell = 0.012;
// How fast less agreement makes a rival less likely.
constexpr double kRivalScale = 0.004;

double logistic(double x) {
  return 1 / (1 + portable_exp(-x));
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::match:
      return "match";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::unknown:
      return "unknown";
    case Verdict::none:
      break;
  }
  return "";
}

Judgement judge(std::span<const Hypothesis> ranked, std::span<const ClassIndex> indexes,
                double confidence_min) {
  Judgement judgement;
  if (ranked.empty() || ranked[0].pose == nullptr) return judgement;
  const Hypothesis& best = ranked[0];
  const Calibration& calibration = indexes[best.index].calibration;
  const double known = logistic(static_cast<double>(calibration.slope) *
                                (static_cast<double>(best.pose->agreement.all_but_rims) -
                                 static_cast<double>(calibration.even)));
  double others = 0;
  bool other_object = false;
  for (std::size_t k = 1; k < ranked.size(); ++k) {
    const Hypothesis& rival = ranked[k];
    if (rival.pose == nullptr) continue;
    const double behind = best.score - rival.score;
    if (rival.index != best.index) others += portable_exp(-behind / kRivalScale);
    if (behind > kAsWell) continue;
    other_object = other_object || rival.index != best.index;
    if (judgement.rival_count < kMaxRivals)
      judgement.rivals[judgement.rival_count++] = static_cast<std::uint8_t>(k);
  }
  judgement.probability = static_cast<float>(known / (1 + others));
  if (known < confidence_min)
    judgement.verdict = Verdict::unknown;
  else if (other_object)
    judgement.verdict = Verdict::ambiguous;
  else
    judgement.verdict = static_cast<double>(judgement.probability) < confidence_min
                            ? Verdict::unknown
                            : Verdict::match;
  return judgement;
}

}  // namespace aspect
