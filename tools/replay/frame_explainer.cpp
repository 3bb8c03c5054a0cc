#include "tools/replay/frame_explainer.h"

#include "tools/replay/explanation_json.h"

namespace aspect {

void FrameExplainer::expect(const RecogniserParameters& parameters,
                            const ExpectedHypothesis& expected) {
  if (!rivals_) rivals_.emplace(indexes_, parameters);
  expected_ = expected;
}

void FrameExplainer::expect_others(const RecogniserParameters& parameters) {
  if (!rivals_) rivals_.emplace(indexes_, parameters);
  others_ = true;
}

std::vector<std::string> FrameExplainer::explain(const Frame& frame, const Recognition& recognition,
                                                 const SizedRecogniser& recogniser) {
  if (recognition.graph.blobs.empty()) return {};
  if (rivals_) {
    rivals_->make_room(frame.width_px, frame.height_px);
    rivals_->look(frame);
  }
  const SeenFrame seen = {recognition.graph, &recogniser.regions(), &recogniser.colours(), indexes_,
                          recogniser.cameras()};
  std::vector<std::string> explanations;
  for (std::size_t k = 0; k < recognition.objects.size(); ++k) {
    const SeenObject& object = recognition.objects[k];
    SeenExplanation best;
    if (!object.hypotheses.empty())
      best = explain_seen(object.hypotheses.front(), object.hypotheses.front().pose,
                          place_of(object, recognition.graph), seen);
    ExplainedRivals rivals;
    const bool seen_again = rivals_ && rivals_->has_seen(k, object.box);
    if (expected_ && seen_again) rivals.expected = rivals_->explain(k, *expected_);
    if (others_ && seen_again) rivals.others = others_of(object, k);
    explanations.push_back(explanation_json(best, rivals, indexes_));
  }
  return explanations;
}

std::vector<std::pair<std::uint16_t, RivalExplanation>> FrameExplainer::others_of(
    const SeenObject& object, std::size_t place) {
  std::optional<std::uint16_t> chosen;
  if (!object.hypotheses.empty() && object.judgement.verdict != Verdict::unknown)
    chosen = object.hypotheses.front().index;
  std::vector<std::pair<std::uint16_t, RivalExplanation>> others;
  for (std::size_t k = 0; k < indexes_.size(); ++k) {
    const auto index = static_cast<std::uint16_t>(k);
    if (index != chosen) others.emplace_back(index, rivals_->explain(place, {index, {}}));
  }
  return others;
}

}  // namespace aspect
