// Plots of how errors are distributed: which share of the views is within which error.
#pragma once

#include <string>

#include "tools/eval/clutter_evaluation.h"
#include "tools/eval/evaluation.h"

namespace aspect {

// An SVG document with a panel for the view's direction, the pose's turn, its place and its
// reprojection: the share of all views (so that those without a pose are missing at the right end)
// within an error, a line an object, its median marked where half of them are within it.
std::string pose_error_svg(const Evaluation& evaluation);

// Of frames in clutter that count in the recall, and without the view's direction.
std::string pose_error_svg(const ClutterEvaluation& evaluation);

}  // namespace aspect
