// aspect-eval: the thesis's experiments with simulated images (4.4).
#include <exception>

#include "tools/command_line/terminal_colour.h"
#include "tools/eval/evaluation_run.h"

int main(int argc, char** argv) {
  try {
    const auto options = aspect::parse_eval_options(argc, argv);
    if (const int* exit_code = std::get_if<int>(&options)) return *exit_code;
    return aspect::run_evaluation(std::get<aspect::EvalOptions>(options));
  } catch (const std::exception& error) {
    aspect::print_failure("aspect-eval", error.what());
    return 1;
  }
}
