// What a region has in place of a mean colour where the sensor measures none: three numbers from 0
// to 255 that add up to 255 and do not change with the camera's roll.
#pragma once

#include <array>
#include <span>

#include "runtime/vision/range_codes.h"
#include "runtime/vision/view_graph.h"

namespace aspect {

// Of the contours of one blob; mean_rgb is their regions' and is replaced.
// Grey: a region's grey against the blob's mean, so that light does not matter.
void colour_by_grey(std::span<Contour> contours);

// Range: how much the surface is turned away from the line of sight.
void colour_by_slant(const RangeCamera& camera, std::span<Contour> contours);

// Surface ids: a colour of the id's own; those of the first ids are far apart.
void colour_by_surface(std::span<Contour> contours);

}  // namespace aspect
