// The appendix's examples, in tests/data/thesis.
#pragma once

#include <string>

#include "tests/temporary_folder.h"

namespace aspect {

inline constexpr const char* kExampleView = "blockcyl+0.222-0.842+0.491";

inline std::string thesis_example(const std::string& name) {
  return read_file(std::string(ASPECT_SOURCE_DIR "/tests/data/thesis/") + name);
}

}  // namespace aspect
