// What a camera measures at every pixel.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "runtime/vision/frame.h"

namespace aspect {

enum class SensorKind : std::uint8_t { colour, grey, range, surface };

inline constexpr std::array<std::string_view, 4> kSensorNames = {"colour", "grey", "range",
                                                                 "surface"};

constexpr std::string_view name_of(SensorKind sensor) {
  return kSensorNames[static_cast<std::size_t>(sensor)];
}

// Whether frames of this format come from such a sensor.
constexpr bool gives(SensorKind sensor, PixelFormat format) {
  switch (format) {
    case PixelFormat::yuyv8:
    case PixelFormat::uyvy8:
    case PixelFormat::nv12:
    case PixelFormat::nv21:
      // Y by itself is grey.
      return sensor == SensorKind::colour || sensor == SensorKind::grey;
    case PixelFormat::rgb8:
    case PixelFormat::bgr8:
    case PixelFormat::rgbx8:
    case PixelFormat::bgrx8:
    case PixelFormat::bayer_rggb8:
    case PixelFormat::bayer_grbg8:
    case PixelFormat::bayer_gbrg8:
    case PixelFormat::bayer_bggr8:
      return sensor == SensorKind::colour;
    case PixelFormat::grey8:
      return sensor == SensorKind::grey;
    case PixelFormat::depth16:
      return sensor == SensorKind::range;
    case PixelFormat::label16:
      return sensor == SensorKind::surface;
  }
  return false;
}

}  // namespace aspect
