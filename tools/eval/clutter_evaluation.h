// Recognition in clutter as numbers: how often an object is found, how well, and how often it is
// named where it is not.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tools/eval/cluttered_frame.h"
#include "tools/eval/evaluation.h"

namespace aspect {

struct ClutterOutcome {
  bool has_object = false;
  double visible = 0;
  bool found = false;             // named where it is
  std::size_t falsely_named = 0;  // matches that are nothing that is there
  std::optional<PoseError> pose;  // of what was found
  double elapsed_ms = 0;
  bool counts() const;  // in the recall: enough of the object is visible
};

struct HiddenRange {
  double from = 0, to = 0;  // shares of the object
};
// [from, to), but for the last, which holds its end.
inline constexpr std::array<HiddenRange, 4> kHiddenRanges = {
    {{0, 0.1}, {0.1, 0.3}, {0.3, 0.5}, {0.5, 0.7}}};

struct Recall {
  std::size_t frames = 0, found = 0;
  std::optional<double> share() const;  // nothing without frames
};

struct ObjectClutter {
  std::string object;
  std::size_t classes = 0, index_bytes = 0;
  std::size_t with_object = 0, empty = 0;  // frames
  Recall recall;                           // of the frames that count
  std::array<Recall, kHiddenRanges.size()> by_hidden{};
  std::optional<PoseSummary> pose;  // of the frames that count; nothing where none was found
  std::size_t falsely_named = 0, falsely_named_in_empty = 0;
  double mean_ms = 0, median_ms = 0;
  std::vector<ClutterOutcome> outcomes;  // frame by frame
};

struct ClutterEvaluation {
  EvaluationSettings settings;
  double hidden_max = 0;
  std::string backgrounds;   // folder; empty: none
  std::size_t pictures = 0;  // of it, that were used
  std::vector<ObjectClutter> objects;
};

// Takes what was made for an object, by its number; an error ends the evaluation.
using FrameTaker = std::function<std::optional<Error>(std::size_t, const ClutteredFrame&)>;

// Frames of one of the objects, recognised with the indexes of all. They are made by several
// threads and recognised by one, in their order; same result for any number of threads, but for the
// times.
Result<ObjectClutter> evaluate_clutter(std::span<const EvaluatedObject> objects, std::size_t place,
                                       const EvaluationSettings& settings,
                                       const ClutterSettings& clutter, const FrameTaker& take);

// Sums over the outcomes.
void summarise(ObjectClutter& clutter);

// Why frames cannot be made for an index and a scene; nothing where they can.
std::optional<Error> clutter_fault(const EvaluatedObject& object);

}  // namespace aspect
