// A score for programs: what score_text.h prints for people.
#pragma once

#include <string>

#include "tools/score/scoring.h"

namespace aspect {

// One object; the frames one by one in it only where they are asked for. A figure of nothing is null.
std::string score_json(const Score& score, bool frames);

}  // namespace aspect
