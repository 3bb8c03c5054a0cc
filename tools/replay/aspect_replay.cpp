// aspect-replay: recorded frames through the runtime.
#include <exception>

#include "runtime/base/standard_streams.h"
#include "tools/command_line/terminal_colour.h"
#include "tools/replay/replay.h"

int main(int argc, char** argv) {
  aspect::guard_standard_streams();
  try {
    const auto options = aspect::parse_replay_options(argc, argv);
    if (const int* exit_code = std::get_if<int>(&options)) return *exit_code;
    return aspect::replay(std::get<aspect::ReplayOptions>(options));
  } catch (const std::exception& error) {
    aspect::print_failure("aspect-replay", error.what());
    return 1;
  }
}
