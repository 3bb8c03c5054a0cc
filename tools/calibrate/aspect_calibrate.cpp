// aspect-calibrate: what a camera and its light are like, measured, for the other programs.
#include <exception>

#include "tools/calibrate/calibrate_program.h"
#include "tools/calibrate/commands/command_end.h"

int main(int argc, char** argv) {
  try {
    return aspect::run_calibrate(argc, argv);
  } catch (const std::exception& error) {
    return aspect::end_failed(error.what());
  }
}
