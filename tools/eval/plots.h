// The plots of an evaluation, as files of one folder.
#pragma once

#include <filesystem>
#include <optional>

#include "tools/eval/clutter_evaluation.h"
#include "tools/eval/evaluation.h"
#include "tools/eval/thesis_ranks.h"

namespace aspect {

// Makes the folder where it is not there, and finds out whether files can be written to it.
std::optional<Error> prepare_plots(const std::filesystem::path& folder);

// rank.svg, pose_error.svg, reliability.svg where something was judged, and confusion.svg of
// several objects.
std::optional<Error> write_plots(const Evaluation& evaluation, const ThesisRanks& thesis,
                                 const std::filesystem::path& folder);

// recall.svg and pose_error.svg.
std::optional<Error> write_plots(const ClutterEvaluation& evaluation,
                                 const std::filesystem::path& folder);

}  // namespace aspect
