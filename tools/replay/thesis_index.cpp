#include "tools/replay/thesis_index.h"

#include "tools/export/formats/pose_file.h"

namespace aspect {
namespace {

// Of the type that the picture's contour has, in the class's contour.
double weight_of(const ContourMatch& match, const ViewGraph& graph, const Blob& blob,
                 const AspectClass& aspect, const ClassIndex& index) {
  const std::uint16_t type = nearest_type(index, feature_of(graph.contours[match.contour], blob));
  const auto contours = ClassIndex::part(index.class_contours, aspect.contours);
  for (const TypeScore& score : ClassIndex::part(index.type_scores, contours[match.name].types))
    if (score.type == type) return static_cast<double>(score.score);
  return 0;
}

PoseProposal proposal_of(const Hypothesis& hypothesis, const Recognition& recognition,
                         const Blob& blob, const ClassIndex& index) {
  const AspectClass& aspect = index.classes[hypothesis.class_id];
  PoseProposal proposal{hypothesis.class_id + std::int64_t{1}, hypothesis.class_score, {}};
  for (const ContourMatch& match : hypothesis.contours)
    proposal.matches.push_back(
        {match.contour, match.name, weight_of(match, recognition.graph, blob, aspect, index)});
  return proposal;
}

}  // namespace

void rank_as_thesis(const ClassIndex& index, RecogniserParameters& parameters) {
  parameters.ranking = RecogniserParameters::Ranking::classes;
  if (index.classes.size() <= kMaxShortlist)
    parameters.shortlist_slack = static_cast<int>(kMaxClassContours);
  parameters.score_min = 0;
  parameters.tracking.on = false;
}

std::string thesis_index_text(std::string_view frame, const Recognition& recognition,
                              const ClassIndex& index) {
  std::vector<UnknownPicture> pictures;
  for (const SeenObject& object : recognition.objects) {
    const std::size_t number = pictures.size() + 1;
    UnknownPicture& picture = pictures.emplace_back();
    picture.name = std::string(frame) + (number > 1 ? ":" + std::to_string(number) : "");
    for (const Hypothesis& hypothesis : object.hypotheses)
      picture.proposals.push_back(
          proposal_of(hypothesis, recognition, recognition.graph.blobs[object.blob], index));
  }
  if (pictures.empty()) pictures.push_back({std::string(frame), {}});
  return poses_text(pictures);
}

}  // namespace aspect
