// Why an object or class that somebody expected was not chosen.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/planned_memory.h"
#include "runtime/base/result.h"
#include "runtime/recognition/sized_recogniser.h"
#include "tools/replay/seen_explanation.h"

namespace aspect {

// Nothing: any.
struct ExpectedHypothesis {
  std::optional<std::uint16_t> index, class_id;

  bool is(const Hypothesis& hypothesis) const {
    return (!index || *index == hypothesis.index) &&
           (!class_id || *class_id == hypothesis.class_id);
  }
};

// OBJECT, OBJECT:CLASS or CLASS, a number. An object's own name goes before the other readings.
Result<ExpectedHypothesis> find_expected(std::string_view name,
                                         std::span<const ClassIndex> indexes);

struct RivalExplanation {
  bool chosen = false, on_shortlist = false;
  std::string reason;  // for a person
  // Ranked by classes: contours matched of the expected, at most, and of those on the shortlist, at
  // least. Both 0 of an object that is a part of its blob, or fills the picture: for these there is
  // no shortlist.
  int matched = 0, needed = 0;
  // Ranked by views: no key view of the expected costs less, by colours, sizes and places.
  std::optional<float> least_cost;
  // The best one that was expected: of the shortlist or, ranked by views, made for this.
  std::optional<Hypothesis> hypothesis;
  int rank = 0;  // in the list of all hypotheses, from 1; 0: not on the shortlist
  std::optional<float> agreement;
  SeenExplanation seen;
};

// Looks at frames once more, with every hypothesis kept.
class RivalExplainer {
 public:
  // `indexes` must outlive it.
  RivalExplainer(std::span<const ClassIndex> indexes, const RecogniserParameters& parameters);

  // After make_room, and once for a frame; then explain() for each of its objects.
  void make_room(int width_px, int height_px) { recogniser_.make_room(width_px, height_px); }
  void look(const Frame& frame);
  // Whether this look has seen the object that another one has seen there: within a time limit no
  // two looks need be alike.
  bool has_seen(std::size_t object, const Box& box) const {
    return object < recognition_.objects.size() && recognition_.objects[object].box == box;
  }
  // Lives until the next look.
  RivalExplanation explain(std::size_t object, const ExpectedHypothesis& expected);

 private:
  void count_matches(const BlobFeatures& seen, const ExpectedHypothesis& expected,
                     RivalExplanation& explanation);
  // Whether any class of any index may be matched.
  bool bound_costs(const BlobFeatures& seen, const ExpectedHypothesis& expected,
                   RivalExplanation& explanation);
  void fit_expected(const BlobFeatures& seen, const ExpectedHypothesis& expected,
                    RivalExplanation& explanation);
  void lay_over(std::size_t object, RivalExplanation& explanation);
  const VerifiedPose* pose_of(const Hypothesis& hypothesis, std::size_t object);

  std::span<const ClassIndex> indexes_;
  RecogniserParameters parameters_;
  SizedRecogniser recogniser_;
  Recognition recognition_;
  PlannedMemory memory_;
  ClassMatcher matcher_;
  ClassBounds bounds_;
  ViewSearch views_;
  PoseFinder finder_;
  VerifiedPose found_;
};

}  // namespace aspect
