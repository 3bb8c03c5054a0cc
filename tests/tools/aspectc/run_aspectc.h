// aspectc as its users start it.
#pragma once

#include "tests/child_program.h"

namespace aspect {

inline Outcome run_aspectc(const std::filesystem::path& folder,
                           const std::vector<std::string>& arguments) {
  return ChildProgram(ASPECTC, folder, arguments).wait();
}

}  // namespace aspect
