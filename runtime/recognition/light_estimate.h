// The light's colour from the object's own colours: matched contours are a colour chart.
#pragma once

#include <span>

#include "runtime/recognition/assignment.h"
#include "runtime/recognition/class_index.h"
#include "runtime/recognition/seen_colours.h"

namespace aspect {

// The diagonal gain under which the key view's shares come nearest to those seen, contours weighed
// by area and channels by how much of them there is. Within a factor of two of white light.
LightGain estimate_light(std::span<const ContourFeature> seen, std::span<const KeyContour> key,
                         const Assignment& assignment);

}  // namespace aspect
