// What a truth table says of a page's frames, by the rules of aspect-score.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/result.h"
#include "tools/score/known_rotations.h"
#include "tools/score/result_lines.h"
#include "tools/score/truth_table.h"

namespace aspect {

class PageTruth {
 public:
  static Result<PageTruth> read(const std::filesystem::path& truth,
                                const std::optional<std::filesystem::path>& symmetries);

  // Of a frame: [{"truth", "found": names, left out where there is none, "counts":
  // enough of it is visible, "right", "deg": error of a view that is right, "view": the true one}];
  // null where the table does not have the frame. Each frame of the table is taken once.
  nlohmann::json score(const FoundFrame& found);
  // The same for a frame without a line: nothing was found.
  nlohmann::json score_unreadable(const std::string& frame);

  // Frames of the table that nobody has asked for so far.
  std::size_t missing() const;

 private:
  nlohmann::json score(const std::string& frame, const FoundFrame* found);

  std::filesystem::path folder_;
  std::vector<TrueFrame> frames_;
  std::vector<bool> taken_;
  KnownRotations rotations_;
};

}  // namespace aspect
