// What aspect-replay printed: a JSON object a line for each frame.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/result.h"
#include "tools/score/truth_table.h"

namespace aspect {

struct FoundObject {
  PixelBox box{};
  bool is_named = false;  // its verdict is a match, or it has none
  std::string object;     // of the first hypothesis
  Eigen::Vector3d view;   // likewise; unit vector
};

struct FoundFrame {
  std::string frame;
  std::uint64_t sequence = 0;
  std::optional<double> elapsed_ms;
  std::vector<FoundObject> objects;  // those with a hypothesis
};

// Errors name file and line.
Result<std::vector<FoundFrame>> read_results(const std::filesystem::path& file);
Result<std::vector<FoundFrame>> parse_results(std::string_view text, const std::string& name);

}  // namespace aspect
