// How large a step of brightness between two pixels says that a border lies between them.
#pragma once

#include "runtime/vision/planes.h"

namespace aspect {

// Of three times the brightness (VisionParameters::intensity_step). Noise is measured where the
// picture is flattest: as the bend of the brightness along rows, of whose absolute values the lower
// half is averaged, so that texture and borders do not count. O(pixels / 16).
int measured_intensity_step(const Planes& planes, int intensity_min);

}  // namespace aspect
