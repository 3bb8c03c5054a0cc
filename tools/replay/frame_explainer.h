// What --explain adds to a frame's line.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tools/replay/rival_explanation.h"

namespace aspect {

class FrameExplainer {
 public:
  // `indexes` must outlive it.
  explicit FrameExplainer(std::span<const ClassIndex> indexes) : indexes_(indexes) {}

  // Explains as well why it is not that. `parameters` are the recogniser's.
  void expect(const RecogniserParameters& parameters, const ExpectedHypothesis& expected) {
    rivals_.emplace(indexes_, parameters, expected);
  }

  // JSON for each object of the frame that the recogniser has just seen.
  std::vector<std::string> explain(const Frame& frame, const Recognition& recognition,
                                   const SizedRecogniser& recogniser);

 private:
  std::span<const ClassIndex> indexes_;
  std::optional<RivalExplainer> rivals_;
};

}  // namespace aspect
