#include "compiler/render/sensor.h"

namespace aspect {

std::unique_ptr<Sensor> make_sensor(const VisionParameters& parameters) {
  switch (parameters.sensor) {
    case SensorKind::colour:
      return make_colour_sensor();
    case SensorKind::grey:
      return make_grey_sensor();
    case SensorKind::range:
      return make_range_sensor(parameters.range);
    case SensorKind::surface:
      return make_surface_sensor();
  }
  return nullptr;
}

}  // namespace aspect
