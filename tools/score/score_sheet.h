// Overlay pictures of all frames on one sheet, with what was found of each below it.
#pragma once

#include <filesystem>
#include <optional>

#include "runtime/base/result.h"
#include "tools/score/scoring.h"

namespace aspect {

// `overlays` is the folder that aspect-replay left them in. A frame without its picture is an
// error.
[[nodiscard]] std::optional<Error> write_score_sheet(const Score& score,
                                                     const std::filesystem::path& overlays,
                                                     const std::filesystem::path& sheet);

// "003: cube (2.4)", several objects with commas between.
std::string frame_caption(const ScoredFrame& frame);

}  // namespace aspect
