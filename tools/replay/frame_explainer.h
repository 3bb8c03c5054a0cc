// What a line tells of its frame beyond what was recognised: why.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tools/replay/rival_explanation.h"

namespace aspect {

class FrameExplainer {
 public:
  // `indexes` must outlive it.
  explicit FrameExplainer(std::span<const ClassIndex> indexes) : indexes_(indexes) {}

  // Explains as well why it is not that, or for each object that is loaded, why it is not that
  // one. Frames are looked at twice then. `parameters` are the recogniser's.
  void expect(const RecogniserParameters& parameters, const ExpectedHypothesis& expected);
  void expect_others(const RecogniserParameters& parameters);

  // JSON for each object of the frame that the recogniser has just seen, none where it has followed
  // them only. The others are a list, key "others".
  std::vector<std::string> explain(const Frame& frame, const Recognition& recognition,
                                   const SizedRecogniser& recogniser);

 private:
  std::vector<std::pair<std::uint16_t, RivalExplanation>> others_of(const SeenObject& object,
                                                                    std::size_t place);

  std::span<const ClassIndex> indexes_;
  std::optional<RivalExplainer> rivals_;
  std::optional<ExpectedHypothesis> expected_;
  bool others_ = false;
};

}  // namespace aspect
