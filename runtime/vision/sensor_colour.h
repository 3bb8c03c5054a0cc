// What a region has in place of a mean colour where the sensor measures none: three numbers from 0
// to 255 that add up to 255 and do not change with the camera's roll.
#pragma once

#include <array>
#include <span>

#include "runtime/vision/view_graph.h"

namespace aspect {

// Of the contours of one blob; mean_rgb is their regions' and is replaced.
// Grey: a region's grey against the blob's mean, so that light does not matter.
void colour_by_grey(std::span<Contour> contours);

// Range: all alike, so that places and shapes alone count. How far a surface is turned from the
// line of sight says nothing that its shape does not, and differs over an aspect: with it, the view
// of L_SHAPE was within 20 degrees in 82 of 100 frames and not in 95, at the weight of a colour.
void colour_alike(std::span<Contour> contours);

// Surface ids: a colour of the id's own; those of the first ids are far apart.
void colour_by_surface(std::span<Contour> contours);

}  // namespace aspect
