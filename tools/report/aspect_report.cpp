// aspect-report: a compiled model as pictures.
#include <exception>

#include "tools/command_line/terminal_colour.h"
#include "tools/report/report_run.h"

int main(int argc, char** argv) {
  try {
    const auto options = aspect::parse_report_options(argc, argv);
    if (const int* exit_code = std::get_if<int>(&options)) return *exit_code;
    return aspect::run_report(std::get<aspect::ReportOptions>(options));
  } catch (const std::exception& error) {
    aspect::print_failure("aspect-report", error.what());
    return 1;
  }
}
