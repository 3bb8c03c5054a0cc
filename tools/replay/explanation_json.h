// Explanations as JSON: the value of an object's key "explanation".
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tools/replay/rival_explanation.h"

namespace aspect {

// As far as somebody asked.
struct ExplainedRivals {
  std::optional<RivalExplanation> expected;
  std::vector<std::pair<std::uint16_t, RivalExplanation>> others;  // with their indexes
};

std::string explanation_json(const SeenExplanation& seen, const ExplainedRivals& rivals,
                             std::span<const ClassIndex> indexes);

}  // namespace aspect
