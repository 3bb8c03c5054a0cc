#include "tools/replay/frame_explainer.h"

#include "tools/replay/explanation_json.h"

namespace aspect {

std::vector<std::string> FrameExplainer::explain(const Frame& frame, const Recognition& recognition,
                                                 const SizedRecogniser& recogniser) {
  if (rivals_) {
    rivals_->make_room(frame.width_px, frame.height_px);
    rivals_->look(frame);
  }
  const SeenFrame seen = {recognition.graph, &recogniser.regions(), &recogniser.colours(), indexes_,
                          recogniser.cameras()};
  std::vector<std::string> explanations;
  for (std::size_t k = 0; k < recognition.objects.size(); ++k) {
    const auto list = recognition.objects[k].hypotheses;
    SeenExplanation best;
    if (!list.empty())
      best = explain_seen(list.front(), list.front().pose, recognition.objects[k].blob, seen);
    std::optional<RivalExplanation> rival;
    if (rivals_) rival = rivals_->explain(k);
    explanations.push_back(explanation_json(best, rival ? &*rival : nullptr, indexes_));
  }
  return explanations;
}

}  // namespace aspect
