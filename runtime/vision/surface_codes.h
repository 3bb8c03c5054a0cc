// Stage "convert" of a surface-id frame: an id is its own code.
#pragma once

#include <array>

#include "runtime/vision/code_planes.h"

namespace aspect {

// Fills codes and foreground. False where the frame shows no surface.
bool find_surface_codes(const Frame& frame, const VisionParameters& parameters, Planes& codes,
                        CodeMasks& masks);

// The id that a code stands for.
int surface_id_of(const std::array<float, 3>& code);

}  // namespace aspect
