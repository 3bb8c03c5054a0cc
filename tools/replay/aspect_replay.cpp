// aspect-replay: recorded frames through the runtime.
#include <cstdio>
#include <exception>

#include "runtime/base/standard_streams.h"
#include "tools/replay/replay.h"

int main(int argc, char** argv) {
  aspect::guard_standard_streams();
  try {
    const auto options = aspect::parse_replay_options(argc, argv);
    if (const int* exit_code = std::get_if<int>(&options)) return *exit_code;
    return aspect::replay(std::get<aspect::ReplayOptions>(options));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "aspect-replay: %s\n", error.what());
    return 1;
  }
}
