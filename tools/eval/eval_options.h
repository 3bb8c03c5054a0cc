// The command line of aspect-eval.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "runtime/recognition/recogniser.h"

namespace aspect {

struct EvalOptions {
  std::vector<std::filesystem::path> indexes, scenes;  // pairs, once files of several are opened
  int views = 100;
  std::uint64_t seed = 1;
  Matching matching = Matching::weighted;
  RecogniserParameters::Ranking ranking = RecogniserParameters::Ranking::views;
  bool json = false;
  std::filesystem::path reliability;  // of a plot; empty: none
  bool clutter = false;               // frames in clutter; what follows is of these
  std::filesystem::path backgrounds;  // folder of pictures; empty: none
  double hidden_max = 0.7;            // share of the object
  std::filesystem::path dump;         // folder that the frames are written to; empty: none
  std::filesystem::path recall;       // of a plot; empty: none
  std::filesystem::path plots;        // folder of all plots; empty: none
  std::filesystem::path thesis;       // table of ranks to draw beside ours; empty: none
};

// The complaint where indexes and scenes are not as many.
std::string pairs_needed(std::size_t indexes, std::size_t scenes);

// The options, or the exit code after help, version or a complaint have been printed.
std::variant<EvalOptions, int> parse_eval_options(int argc, const char* const* argv);

}  // namespace aspect
