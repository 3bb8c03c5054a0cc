// aspect-export: a store's model in the formats of the thesis's appendix A.2.
#include <csignal>
#include <exception>

#include "runtime/base/standard_streams.h"
#include "tools/aspectc/progress/stop_signals.h"
#include "tools/command_line/terminal_colour.h"
#include "tools/export/export_run.h"

int main(int argc, char** argv) {
  aspect::guard_standard_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error like a full disk
  try {
    const auto options = aspect::parse_export_options(argc, argv);
    if (const int* exit_code = std::get_if<int>(&options)) return *exit_code;
    const auto& stop = aspect::stop_on_signals("aspect-export: stopped; run it again");
    return aspect::run_export(std::get<aspect::ExportOptions>(options), &stop);
  } catch (const std::exception& error) {
    aspect::print_failure("aspect-export", error.what());
    return 1;
  }
}
