// All that is asked of one object's compilation, in words.
#pragma once

#include <string>

#include "tools/aspectc/options/compile_settings.h"

namespace aspect {

// Settings with the same text give the same index; so the number of threads is left out.
std::string settings_text(const CompileSettings& settings);

}  // namespace aspect
