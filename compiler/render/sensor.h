// What a camera of some kind makes of a rendered view: the frame that it would give. Another sensor
// is another file that implements this, and a case in make_sensor.
#pragma once

#include <memory>

#include "compiler/render/renderer.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

class Sensor {
 public:
  virtual ~Sensor() = default;

  // The frame lives until the next call and as long as the picture does.
  virtual Frame frame_of(const Picture& picture) = 0;
};

std::unique_ptr<Sensor> make_colour_sensor();
std::unique_ptr<Sensor> make_grey_sensor();
std::unique_ptr<Sensor> make_range_sensor(const RangeParameters& range);
std::unique_ptr<Sensor> make_surface_sensor();

// The sensor whose frames vision with these parameters takes.
std::unique_ptr<Sensor> make_sensor(const VisionParameters& parameters);

}  // namespace aspect
