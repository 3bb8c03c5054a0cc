// A small model that reports are tried on, made once a program.
#pragma once

#include "compiler/compile.h"

namespace aspect {

// A cube of six colours at level 3, its borders divided: 26 aspects in theory (thesis 4.3.1).
const Scene& cube_scene();
const CompileOptions& cube_options();
const LearntModel& cube_model();

}  // namespace aspect
