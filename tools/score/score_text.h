// A score as tables to read.
#pragma once

#include <string>

#include "tools/score/scoring.h"

namespace aspect {

// A line for each object in each frame: frame, true object, found object, error of the view in
// degrees, milliseconds. In brackets: too little of it is visible to count.
// What is found in colour for a terminal: right or not.
std::string score_table(const Score& score, bool colours = false);

// A line for each object and one for all.
std::string score_summary(const Score& score);

}  // namespace aspect
