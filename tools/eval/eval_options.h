// The command line of aspect-eval.
#pragma once

#include <cstdint>
#include <filesystem>
#include <variant>
#include <vector>

#include "runtime/recognition/recogniser.h"

namespace aspect {

struct EvalOptions {
  std::vector<std::filesystem::path> indexes, scenes;  // pairs
  int views = 100;
  std::uint64_t seed = 1;
  Matching matching = Matching::weighted;
  RecogniserParameters::Ranking ranking = RecogniserParameters::Ranking::views;
  bool json = false;
};

// The options, or the exit code after help, version or a complaint have been printed.
std::variant<EvalOptions, int> parse_eval_options(int argc, const char* const* argv);

}  // namespace aspect
