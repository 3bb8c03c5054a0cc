#include "tools/replay/rival_explanation.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <vector>

#include "runtime/base/nearest_word.h"
#include "runtime/vision/vision_limits.h"

namespace aspect {
namespace {

RecogniserParameters keeping_all(RecogniserParameters parameters) {
  parameters.top = kMaxHypotheses;
  parameters.score_min = 0;
  return parameters;
}

std::optional<std::uint16_t> class_number(std::string_view text) {
  std::uint16_t number = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, number);
  if (parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
  return number;
}

std::optional<std::uint16_t> index_named(std::string_view name,
                                         std::span<const ClassIndex> indexes) {
  for (std::size_t k = 0; k < indexes.size(); ++k)
    if (indexes[k].object == name) return static_cast<std::uint16_t>(k);
  return std::nullopt;
}

std::string reason_for(const RivalExplanation& rival, const Hypothesis& best,
                       const Judgement& judgement, std::span<const ClassIndex> indexes) {
  if (rival.chosen) return "it was chosen";
  if (rival.rank == 1)
    return fmt::format("it comes first, but with a probability of {:.2f}, which is too low",
                       judgement.probability);
  const std::string chosen = fmt::format("{} class {}", indexes[best.index].object, best.class_id);
  const Hypothesis& own = *rival.hypothesis;
  if (best.pose == nullptr)
    return fmt::format("it scores {:.9g}, {} {:.9g}", own.score, chosen, best.score);
  const std::string explained = fmt::format("{} explains {:.1f} %", chosen, 100 * best.score);
  if (own.pose != nullptr)
    return fmt::format("drawn as found it explains {:.1f} % of the picture, {}", 100 * own.score,
                       explained);
  std::string reason = "its key views fit worse, so that no pose of it was tried";
  if (rival.agreement)
    reason += fmt::format("; where they have it, it explains {:.1f} % of the picture, {}",
                          100 * *rival.agreement, explained);
  return reason;
}

std::string why_not_on_shortlist(const RivalExplanation& rival, std::size_t contours) {
  if (!rival.least_cost)
    return fmt::format("not on the shortlist: of {} contours it matches {}, {} were needed",
                       contours, rival.matched, rival.needed);
  return fmt::format(
      "not on the shortlist: by colours, sizes and places of what is seen each of its views costs "
      "{:.1f} or more",
      *rival.least_cost);
}

Hypothesis class_hypothesis(std::size_t index, std::size_t class_id) {
  Hypothesis hypothesis;
  hypothesis.index = static_cast<std::uint16_t>(index);
  hypothesis.class_id = static_cast<std::uint16_t>(class_id);
  return hypothesis;
}

std::vector<Hypothesis> every_class(std::span<const ClassIndex> indexes) {
  std::vector<Hypothesis> all;
  for (std::size_t i = 0; i < indexes.size(); ++i)
    for (std::size_t c = 0; c < indexes[i].classes.size(); ++c)
      all.push_back(class_hypothesis(i, c));
  return all;
}

}  // namespace

Result<ExpectedHypothesis> find_expected(std::string_view name,
                                         std::span<const ClassIndex> indexes) {
  const auto fault = [&](const std::string& what) {
    return Error{fmt::format("--explain {}: {}", name, what)};
  };
  if (const auto index = index_named(name, indexes)) return ExpectedHypothesis{index, {}};
  if (const auto number = class_number(name)) {
    for (const ClassIndex& index : indexes)
      if (*number < index.classes.size()) return ExpectedHypothesis{{}, number};
    return fault("no index has a class of that number; give a smaller one, or an object");
  }
  const std::size_t colon = name.rfind(':');
  const std::string_view object = name.substr(0, colon);
  const auto index = index_named(object, indexes);
  if (!index) {
    std::vector<std::string_view> names;
    for (const ClassIndex& known : indexes) names.emplace_back(known.object);
    return fault(fmt::format("no index of such an object is loaded; did you mean {}?",
                             nearest_word(object, names)));
  }
  const std::size_t classes = indexes[*index].classes.size();
  const auto number =
      colon == std::string_view::npos ? std::nullopt : class_number(name.substr(colon + 1));
  if (!number || *number >= classes)
    return fault(fmt::format("classes of {} are numbered from 0 to {}; give one of them", object,
                             static_cast<int>(classes) - 1));
  return ExpectedHypothesis{index, number};
}

RivalExplainer::RivalExplainer(std::span<const ClassIndex> indexes,
                               const RecogniserParameters& parameters)
    : indexes_(indexes), parameters_(keeping_all(parameters)), recogniser_(indexes, parameters_) {
  memory_.plan([&](Arena& arena) {
    matcher_.prepare(arena, indexes_);
    bounds_.prepare(arena, indexes_);
    views_.prepare(indexes_);
    finder_.prepare(arena, indexes_);
  });
}

void RivalExplainer::look(const Frame& frame) {
  recognition_ = recogniser_.recognise(frame);
}

RivalExplanation RivalExplainer::explain(std::size_t object, const ExpectedHypothesis& expected) {
  RivalExplanation rival;
  const auto list = recognition_.objects[object].hypotheses;
  const std::size_t blob = recognition_.objects[object].blob;
  const bool is_part = place_of(recognition_.objects[object], recognition_.graph).part.has_value();
  BlobFeatures seen;
  if (!is_part) {
    features_of(recognition_.graph, blob, seen);
    bool may_match = true;
    if (parameters_.ranking == RecogniserParameters::Ranking::classes) {
      count_matches(seen, expected, rival);
    } else {
      may_match = bound_costs(seen, expected, rival);
      BlobFeatures joined;
      if (join_alike(recognition_.graph, recogniser_.regions(), blob, parameters_.vision, joined))
        may_match = bound_costs(joined, expected, rival) || may_match;
    }
    // Some class is always on the shortlist of what was compared.
    if (list.empty() && may_match) {
      rival = {};
      rival.reason = parameters_.time_limit.count() > 0
                         ? "there was no time left to compare it"
                         : "it fills the picture, which no object alone does: models were laid "
                           "over it, and what fitted is listed for itself";
      return rival;
    }
  }
  const auto own =
      std::find_if(list.begin(), list.end(), [&](const Hypothesis& h) { return expected.is(h); });
  if (own == list.end() && is_part) {
    rival.reason = "models were laid over this part of the picture, and no pose of it fits better";
    return rival;
  }
  if (own == list.end()) {
    rival.on_shortlist = list.size() == kMaxHypotheses;
    rival.reason = rival.on_shortlist ? fmt::format("{} others fit better", list.size())
                                      : why_not_on_shortlist(rival, seen.count);
    if (rival.least_cost) fit_expected(seen, expected, rival);
    if (rival.hypothesis) lay_over(object, rival);
    return rival;
  }
  rival.on_shortlist = true;
  rival.rank = static_cast<int>(own - list.begin()) + 1;
  const Judgement& judgement = recognition_.objects[object].judgement;
  rival.chosen = rival.rank == 1 && judgement.verdict != Verdict::unknown;
  rival.hypothesis = *own;
  lay_over(object, rival);
  rival.reason = reason_for(rival, list.front(), judgement, indexes_);
  return rival;
}

void RivalExplainer::lay_over(std::size_t object, RivalExplanation& rival) {
  const VerifiedPose* pose = pose_of(*rival.hypothesis, object);
  if (pose != nullptr) rival.agreement = pose->agreement.all_but_rims;
  rival.seen = explain_seen(*rival.hypothesis, pose,
                            place_of(recognition_.objects[object], recognition_.graph),
                            {recognition_.graph, &recogniser_.regions(), &recogniser_.colours(),
                             indexes_, recogniser_.cameras()});
}

// The best of all its views, however badly it fits.
void RivalExplainer::fit_expected(const BlobFeatures& seen, const ExpectedHypothesis& expected,
                                  RivalExplanation& rival) {
  std::vector<Hypothesis> room;
  for (const Hypothesis& hypothesis : every_class(indexes_))
    if (expected.is(hypothesis)) room.push_back(hypothesis);
  room.resize(views_.run(seen.seen(), room, room.size()));
  const auto best = std::min_element(room.begin(), room.end(), better);
  if (best != room.end() && best->score > 0) rival.hypothesis = *best;
}

bool RivalExplainer::bound_costs(const BlobFeatures& seen, const ExpectedHypothesis& expected,
                                 RivalExplanation& rival) {
  bounds_.set_contours(seen.seen());
  bool may_match = false;
  for (const Hypothesis& hypothesis : every_class(indexes_)) {
    const float cost = bounds_.least_cost(hypothesis.index, hypothesis.class_id);
    may_match = may_match || cost < bounds_.most_cost();
    if (expected.is(hypothesis)) rival.least_cost = std::min(rival.least_cost.value_or(cost), cost);
  }
  return may_match;
}

void RivalExplainer::count_matches(const BlobFeatures& seen, const ExpectedHypothesis& expected,
                                   RivalExplanation& rival) {
  int most = 0;
  for (std::size_t i = 0; i < indexes_.size(); ++i) {
    matcher_.set_contours(indexes_[i], seen.seen());
    for (std::size_t c = 0; c < indexes_[i].classes.size(); ++c) {
      const int matched = matcher_.match(indexes_[i], c, parameters_.matching).assignment.matched;
      most = std::max(most, matched);
      if (expected.is(class_hypothesis(i, c))) rival.matched = std::max(rival.matched, matched);
    }
  }
  rival.needed = std::max(1, most - parameters_.shortlist_slack);
}

// Its own or, where none was tried, the one that its key view leads to.
const VerifiedPose* RivalExplainer::pose_of(const Hypothesis& hypothesis, std::size_t object) {
  if (hypothesis.pose != nullptr) return hypothesis.pose;
  const ClassIndex& index = indexes_[hypothesis.index];
  const bool has_start = parameters_.ranking == RecogniserParameters::Ranking::views &&
                         parameters_.poses && hypothesis.score > 0 &&
                         parameters_.vision.sensor == SensorKind::colour && !index.model.empty();
  if (!has_start) return nullptr;
  constexpr int kRounds = 7;  // as many as the recogniser takes
  const CameraModel& camera = recogniser_.cameras()[hypothesis.index];
  const RigidPose start = finder_.start(index, hypothesis.start, camera,
                                        recognition_.graph.blobs[recognition_.objects[object].blob],
                                        recogniser_.regions().looked_at);
  found_ = finder_.verify(index, start, hypothesis.start.light, camera, recogniser_.regions(),
                          recogniser_.colours(), static_cast<int>(object), kRounds);
  return &found_;
}

}  // namespace aspect
