// The commands of aspect-calibrate.
#pragma once

namespace aspect {

// The program's exit code.
int run_calibrate(int argc, const char* const* argv);

}  // namespace aspect
