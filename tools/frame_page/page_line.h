// A line of aspect-replay, checked and made as short as a page needs it.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/recognition/rigid_pose.h"
#include "tools/score/result_lines.h"

namespace aspect {

// Of a page's objects: how many hypotheses, the best ones, and how many rows of an explanation.
inline constexpr std::size_t kPageHypotheses = 10, kPageRows = 12;
// aspect-replay itself writes no longer ones.
inline constexpr std::size_t kMostLineBytes = 8U << 20U;

struct NamedPose {
  std::string object;
  RigidPose pose;
};

struct PageLine {
  std::string frame;
  std::uint64_t sequence = 0;
  int width_px = 0, height_px = 0;
  // What a list of frames needs: {"name", "n", "w", "h", "ms", "objects": [{"box", "regions",
  // "verdict", "p", "track", "object", "class", "score", the latter of the best hypothesis}]}.
  nlohmann::json summary;
  // The rest, with the line's own keys: {"stages_ms", "objects": [{"rivals", "hypotheses",
  // "explanation"}], "left_undone", "hypotheses_cut", "objects_cut"}.
  nlohmann::json details;
  std::vector<NamedPose> poses;  // of matches and of what is ambiguous
  FoundFrame found;              // as aspect-score reads the line
};

// `where` is what an error begins with: the file and the line.
Result<PageLine> read_page_line(std::string_view line, const std::string& where);

}  // namespace aspect
