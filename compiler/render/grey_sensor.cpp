#include "compiler/render/sensor.h"

namespace aspect {
namespace {

class GreySensor : public Sensor {
 public:
  Frame frame_of(const Picture& picture) override {
    // ITU-R BT.601, as cameras and OpenCV weigh colours.
    constexpr unsigned kRed = 77, kGreen = 150, kBlue = 29, kHalf = 128;
    grey_.resize(picture.rgb.size() / 3);
    const std::uint8_t* rgb = picture.rgb.data();
    for (std::size_t i = 0; i < grey_.size(); ++i, rgb += 3)
      grey_[i] = static_cast<std::uint8_t>(
          (kRed * rgb[0] + kGreen * rgb[1] + kBlue * rgb[2] + kHalf) >> 8U);
    return {grey_.data(), picture.width_px, picture.height_px, picture.width_px,
            PixelFormat::grey8};
  }

 private:
  std::vector<std::uint8_t> grey_;
};

}  // namespace

std::unique_ptr<Sensor> make_grey_sensor() {
  return std::make_unique<GreySensor>();
}

}  // namespace aspect
