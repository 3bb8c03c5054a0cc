#include "compiler/render/sensor.h"

namespace aspect {
namespace {

class ColourSensor : public Sensor {
 public:
  Frame frame_of(const Picture& picture) override {
    return {picture.rgb.data(), picture.width_px, picture.height_px,
            3 * static_cast<std::ptrdiff_t>(picture.width_px), PixelFormat::rgb8};
  }
};

}  // namespace

std::unique_ptr<Sensor> make_colour_sensor() {
  return std::make_unique<ColourSensor>();
}

}  // namespace aspect
