// A plot of rank accumulation: how often the right class is among the first n.
#pragma once

#include <string>

#include "tools/eval/evaluation.h"
#include "tools/eval/thesis_ranks.h"

namespace aspect {

inline constexpr int kPlottedRanks = 10;

// % of the views whose right class is among the first n.
double percent_within(std::span<const ViewOutcome> outcomes, int most, bool with_symmetry);

// An SVG document: a line for each object over n of 1 to 10, without its symmetry on the left and
// with it on the right; the thesis's of the same objects dashed on the left, where it does not know
// symmetry either.
std::string rank_svg(const Evaluation& evaluation, const ThesisRanks& thesis);

}  // namespace aspect
