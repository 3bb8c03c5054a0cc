#include "compiler/render/sensor.h"

namespace aspect {
namespace {

// Depths in whole steps; what is nearer than one step or farther than 65534 is not measured.
class RangeSensor : public Sensor {
 public:
  explicit RangeSensor(float step_length) : step_length_(step_length) {}

  Frame frame_of(const Picture& picture) override {
    constexpr float kLeast = 1, kMost = 65534;
    steps_.resize(picture.depth.size());
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const float steps = picture.depth[i] / step_length_ + 0.5F;
      const bool measured = steps >= kLeast && steps < kMost + 1;
      steps_[i] = measured ? static_cast<std::uint16_t>(steps) : std::uint16_t{0};
    }
    return {reinterpret_cast<const std::uint8_t*>(steps_.data()), picture.width_px,
            picture.height_px, 2 * static_cast<std::ptrdiff_t>(picture.width_px),
            PixelFormat::depth16};
  }

 private:
  float step_length_;
  std::vector<std::uint16_t> steps_;
};

}  // namespace

std::unique_ptr<Sensor> make_range_sensor(const RangeParameters& range) {
  return std::make_unique<RangeSensor>(range.step_length);
}

}  // namespace aspect
