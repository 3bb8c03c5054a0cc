#include "compiler/render/sensor.h"

namespace aspect {
namespace {

class SurfaceSensor : public Sensor {
 public:
  Frame frame_of(const Picture& picture) override {
    return {reinterpret_cast<const std::uint8_t*>(picture.surface.data()), picture.width_px,
            picture.height_px, 2 * static_cast<std::ptrdiff_t>(picture.width_px),
            PixelFormat::label16};
  }
};

}  // namespace

std::unique_ptr<Sensor> make_surface_sensor() {
  return std::make_unique<SurfaceSensor>();
}

}  // namespace aspect
