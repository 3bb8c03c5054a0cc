// What is asked of a camera.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/vision/sensor_kind.h"

namespace aspect {

struct CameraControl {
  std::string name;        // the driver's, in lower case with underscores, as in v4l2-ctl
  std::int64_t value = 0;  // of a menu: the number of the item
  friend bool operator==(const CameraControl&, const CameraControl&) = default;
};

struct CameraSettings {
  // A node (/dev/video0), a place that stays the same when nodes are numbered anew
  // (bus:usb-0000:01:00.0-1.2, as the driver reports it) or a unit (serial:SN0012, USB cameras).
  std::string device = "/dev/video0";

  int width_px = 640, height_px = 480;  // the nearest that the camera has is taken
  std::optional<double> rate_hz;        // frames a second; none: as the camera is
  std::string format;                   // four characters, as YUYV; empty: the cheapest one for us
  std::vector<CameraControl> controls;  // set in this order
  SensorKind sensor = SensorKind::colour;

  // A stream that gives nothing for so long is started anew.
  std::chrono::milliseconds stall{1000};

  friend bool operator==(const CameraSettings&, const CameraSettings&) = default;
};

}  // namespace aspect
