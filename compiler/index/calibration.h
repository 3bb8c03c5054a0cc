// How surely an index knows its object: measured on frames made for it.
#pragma once

#include <optional>
#include <span>

#include "compiler/aspects/subdivision.h"
#include "runtime/recognition/class_index.h"

namespace aspect {

// Frames of the object at several sizes, in other light, with blur and noise, and as many of what
// is not the object: with one surface of another of its colours, of other proportions, and in other
// colours altogether. The curve is the likeliest one, for as many objects as others (Platt,
// Probabilistic outputs, 1999). Nothing where the index has no model. Same result for any number of
// threads.
std::optional<Calibration> calibrated(const Workshop& workshop, const Scene& scene,
                                      const ClassIndex& index);

// What a frame of the object or of something else came to.
struct CalibrationSample {
  float agreement = 0;
  bool is_object = false;
};

// Of those that a grid holds, the curve under which the samples are likeliest.
Calibration likeliest_calibration(std::span<const CalibrationSample> samples);

}  // namespace aspect
