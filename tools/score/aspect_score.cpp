// aspect-score: what aspect-replay found against the truth.
#include <exception>

#include "tools/command_line/terminal_colour.h"
#include "tools/score/score_run.h"

int main(int argc, char** argv) {
  try {
    const auto options = aspect::parse_score_options(argc, argv);
    if (const int* exit_code = std::get_if<int>(&options)) return *exit_code;
    return aspect::run_score(std::get<aspect::ScoreOptions>(options));
  } catch (const std::exception& error) {
    aspect::print_failure("aspect-score", error.what());
    return 1;
  }
}
