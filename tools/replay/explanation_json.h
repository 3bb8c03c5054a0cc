// Explanations as JSON: the value of an object's key "explanation".
#pragma once

#include <span>
#include <string>

#include "tools/replay/rival_explanation.h"

namespace aspect {

// `rival` null: nobody asked.
std::string explanation_json(const SeenExplanation& seen, const RivalExplanation* rival,
                             std::span<const ClassIndex> indexes);

}  // namespace aspect
