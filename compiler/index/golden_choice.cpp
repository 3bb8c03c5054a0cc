#include "compiler/index/golden_choice.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/aspects/observer.h"
#include "compiler/index/golden_picture.h"
#include "runtime/recognition/self_test.h"

namespace aspect {
namespace {

// Eight views are rendered and seen in 1 % of the shortest compilations; the first ones nearly
// always do.
constexpr std::size_t kMostCandidates = 8;

// A board tests itself with every index before its first frame, and what a picture costs there goes
// with its pixels: a small one is tried beside the full one.
constexpr std::array<int, 2> kGoldenSides_px{200, kMaxGoldenSide_px};

// Of the table, its fields, its two vectors' lengths and what aligns them.
constexpr std::size_t kTableBytes = 96;

constexpr double kLeadShare = 0.75;

// A picture of one or two contours would test little.
constexpr int kEnoughRegions = 3;

// Scores are kept in 16 bits.
constexpr float kScoreUnit = 65535;

struct Answered {
  GoldenFrame golden;
  double lead = 0;
};

std::optional<Answered> answered(const ClassIndex& index, const GoldenFrame& candidate) {
  if (candidate.class_id >= index.classes.size()) return std::nullopt;
  const GoldenAnswer answer = golden_answer(index, candidate);
  if (!answer.own || answer.own->matched != answer.regions) return std::nullopt;
  Answered found{candidate, answer.own->score - answer.rival_score};
  found.golden.regions = answer.regions;
  found.golden.matched = answer.own->matched;
  found.golden.score = std::round(static_cast<float>(answer.own->score) * kScoreUnit) / kScoreUnit;
  if (!is_expected(answer, found.golden)) return std::nullopt;
  return found;
}

}  // namespace

std::size_t golden_bytes(const GoldenFrame& golden) {
  return golden.palette.size() + golden.rows.size() + kTableBytes;
}

std::vector<GoldenFrame> golden_candidates(const Workshop& workshop, const Subdivision& subdivision,
                                           std::span<const Cluster> clusters,
                                           std::span<const ClassDescription> classes) {
  const SensorKind sensor = workshop.options.vision.sensor;
  if (!has_golden_frames(sensor)) return {};
  const std::size_t count = std::min(kMostCandidates, clusters.size());
  const std::size_t most_bytes = std::min(kMostGoldenBytes, workshop.options.max_index_bytes / 8);
  std::vector<std::array<std::optional<GoldenFrame>, kGoldenSides_px.size()>> encoded(count);
  tbb::enumerable_thread_specific<Observer> observers([&workshop] {
    return Observer(workshop.renderer, workshop.studio, workshop.options.vision);
  });
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t c) {
    Observer& observer = observers.local();
    observer.observe(subdivision.direction(clusters[c].views[classes[c].typical_view].vertex));
    const auto picture = palette_picture(observer.frame(), observer.regions(), sensor);
    if (!picture) return;
    for (std::size_t k = 0; k < kGoldenSides_px.size(); ++k) {
      std::optional<GoldenFrame>& golden = encoded[c][k];
      golden = encode_golden_frame(thinned_out(*picture, kGoldenSides_px[k]));
      if (golden) golden->class_id = static_cast<std::uint16_t>(c);
    }
  });
  std::vector<GoldenFrame> candidates;
  for (auto& sizes : encoded)
    for (std::optional<GoldenFrame>& golden : sizes)
      if (golden && golden_bytes(*golden) <= most_bytes) candidates.push_back(std::move(*golden));
  return candidates;
}

std::optional<GoldenFrame> choose_golden_frame(const ClassIndex& index,
                                               std::span<const GoldenFrame> candidates) {
  std::vector<std::optional<Answered>> answers(candidates.size());
  tbb::parallel_for(std::size_t{0}, candidates.size(),
                    [&](std::size_t k) { answers[k] = answered(index, candidates[k]); });
  int most_regions = 0;
  for (const std::optional<Answered>& answer : answers)
    if (answer) most_regions = std::max(most_regions, answer->golden.regions);
  double most_lead = -kGoldenScoreTolerance;
  for (std::optional<Answered>& answer : answers) {
    if (answer && answer->golden.regions < std::min(kEnoughRegions, most_regions)) answer.reset();
    if (answer) most_lead = std::max(most_lead, answer->lead);
  }
  const double least_lead = std::min(kLeadShare * most_lead, most_lead);
  const GoldenFrame* best = nullptr;
  for (const std::optional<Answered>& answer : answers) {
    if (!answer || answer->lead < least_lead) continue;
    if (best == nullptr || golden_bytes(answer->golden) < golden_bytes(*best))
      best = &answer->golden;
  }
  return best == nullptr ? std::nullopt : std::optional(*best);
}

}  // namespace aspect
