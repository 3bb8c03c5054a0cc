// aspect-score: what aspect-replay found against the truth.
#include <cstdio>
#include <exception>

#include "tools/score/score_run.h"

int main(int argc, char** argv) {
  try {
    const auto options = aspect::parse_score_options(argc, argv);
    if (const int* exit_code = std::get_if<int>(&options)) return *exit_code;
    return aspect::run_score(std::get<aspect::ScoreOptions>(options));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "aspect-score: %s\n", error.what());
    return 1;
  }
}
