// Everything of an evaluation as one JSON object.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "tools/eval/evaluation.h"

namespace aspect {

std::string evaluation_json(const Evaluation& evaluation);

// Parts of it; null where there is none.
nlohmann::ordered_json poses_json(const std::optional<PoseSummary>& pose);
nlohmann::ordered_json pose_error_json(const std::optional<PoseError>& error);

}  // namespace aspect
