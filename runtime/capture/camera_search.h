// Which node is the camera.
#pragma once

#include <linux/videodev2.h>

#include <cstdint>
#include <string>

#include "runtime/capture/camera_fault.h"
#include "runtime/capture/v4l2_calls.h"

namespace aspect {

struct DeviceFolders {
  std::string classes = "/sys/class/video4linux";
  std::string nodes = "/dev";
};

struct FoundCamera {
  int descriptor = -1;
  std::string node, driver, card, bus;
  v4l2_buf_type buffer_type = V4L2_BUF_TYPE_VIDEO_CAPTURE;  // or ..._MPLANE

  bool multiplanar() const { return buffer_type == V4L2_BUF_TYPE_VIDEO_CAPTURE_MPLANE; }
};

// Opens what `device` of CameraSettings names; of several nodes of a unit the first one that takes
// pictures. Nothing stays open where it fails.
CameraFault find_camera(V4l2Calls& calls, const DeviceFolders& folders, const std::string& device,
                        FoundCamera& found);

}  // namespace aspect
