// A numpy array as a frame, without a copy of its pixels.
#pragma once

#include <pybind11/numpy.h>

#include <string>

#include "runtime/c_interface/aspect.h"

namespace aspect {

// The format by its name, empty: as the array's shape and type say, where H x W x 3 is
// `colour_format`. Throws pybind11::value_error or type_error with what is wrong and what to do.
// The frame is good as long as the array is.
aspect_frame array_frame(const pybind11::array& pixels, const std::string& format,
                         const std::string& colour_format);

}  // namespace aspect
