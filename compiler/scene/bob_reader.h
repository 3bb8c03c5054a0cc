// Reader of Bob scenes (.b with .bo and .bc includes).
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "compiler/scene/scene.h"
#include "runtime/base/result.h"

namespace aspect {

// Reads a scene file. Errors are one line `file:line: what is wrong; what would be right`, followed
// by the include chain where there is one. Never trusts the file: every number is checked, macro
// expansion is bounded by 1,000,000 words.
// `missing_colour` stands for every colour that is not defined and every map that is not found;
// without it they are errors.
Result<Scene> read_bob(const std::filesystem::path& file,
                       const std::vector<std::filesystem::path>& include_path = {},
                       const std::optional<Eigen::Vector3d>& missing_colour = std::nullopt);

// The same from text in memory; `name` stands for the file in messages.
Result<Scene> parse_bob(std::string_view text, const std::filesystem::path& name,
                        const std::vector<std::filesystem::path>& include_path = {},
                        const std::optional<Eigen::Vector3d>& missing_colour = std::nullopt);

}  // namespace aspect
