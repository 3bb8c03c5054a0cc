// The command line of aspect-score.
#pragma once

#include <filesystem>
#include <optional>
#include <variant>

namespace aspect {

struct ScoreOptions {
  std::filesystem::path truth, results;
  std::optional<std::filesystem::path> symmetries;
  bool table = false, json = false;
  std::optional<std::filesystem::path> sheet, overlays;
  std::optional<double> min_right_percent, max_median_deg, min_within20_percent;
};

// The options, or the exit code after help, version or a complaint have been printed.
std::variant<ScoreOptions, int> parse_score_options(int argc, const char* const* argv);

}  // namespace aspect
