#include "runtime/capture/camera_search.h"

#include <dirent.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <string_view>
#include <vector>

#include "runtime/capture/v4l2_text.h"

namespace aspect {
namespace {

constexpr std::string_view kBus = "bus:", kSerial = "serial:";

CameraFault open_node(V4l2Calls& calls, const std::string& node, FoundCamera& found) {
  const int descriptor = calls.open(node.c_str());
  if (descriptor < 0) return call_fault(node.c_str(), -descriptor);
  v4l2_capability answer{};
  const int error = calls.ioctl(descriptor, VIDIOC_QUERYCAP, &answer);
  if (error != 0) {
    calls.close(descriptor);
    if (error == ENOTTY || error == EINVAL)
      return camera_fault(CameraState::failed, "%s is not a video device; give another one",
                          node.c_str());
    return call_fault("VIDIOC_QUERYCAP", error);
  }
  const std::uint32_t abilities =
      (answer.capabilities & V4L2_CAP_DEVICE_CAPS) != 0 ? answer.device_caps : answer.capabilities;
  const bool single = (abilities & V4L2_CAP_VIDEO_CAPTURE) != 0;
  const bool multi = (abilities & V4L2_CAP_VIDEO_CAPTURE_MPLANE) != 0;
  found.node = node;
  if ((!single && !multi) || (abilities & V4L2_CAP_STREAMING) == 0) {
    calls.close(descriptor);
    return camera_fault(CameraState::failed,
                        "%s does not take pictures into mapped memory; give another node",
                        node.c_str());
  }
  found = {descriptor,
           node,
           v4l2_text(answer.driver),
           v4l2_text(answer.card),
           v4l2_text(answer.bus_info),
           single ? V4L2_BUF_TYPE_VIDEO_CAPTURE : V4L2_BUF_TYPE_VIDEO_CAPTURE_MPLANE};
  return {};
}

// video0, video1, ...: by their numbers. With 64 bits on every machine: places in a folder of a
// 64-bit kernel need not fit into 32.
std::vector<std::string> node_names(const std::string& folder) {
  std::vector<std::string> names;
  const auto close = [](DIR* open) { ::closedir(open); };
  const std::unique_ptr<DIR, decltype(close)> listing(::opendir(folder.c_str()), close);
  while (const dirent64* entry = listing ? ::readdir64(listing.get()) : nullptr)
    if (std::string_view(entry->d_name).starts_with("video")) names.emplace_back(entry->d_name);
  std::ranges::sort(names, [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
  return names;
}

// The node's device is an interface of a USB device, which has the serial number.
std::string serial_of(const std::string& class_folder) {
  const std::string path = class_folder + "/device/../serial";
  const auto close = [](std::FILE* open) { std::fclose(open); };
  const std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "re"), close);
  char text[256];
  if (!file) return {};
  char* end = text + std::fread(text, 1, sizeof text, file.get());
  return v4l2_text(text, static_cast<std::size_t>(std::find(text, end, '\n') - text));
}

}  // namespace

CameraFault find_camera(V4l2Calls& calls, const DeviceFolders& folders, const std::string& device,
                        FoundCamera& found) {
  if (device.starts_with('/')) return open_node(calls, device, found);
  const bool by_bus = device.starts_with(kBus), by_serial = device.starts_with(kSerial);
  const std::string wanted = device.substr(std::min(device.find(':') + 1, device.size()));
  if ((!by_bus && !by_serial) || wanted.empty())
    return camera_fault(CameraState::failed,
                        "'%.80s' names no camera; give a path, bus:PLACE or serial:NUMBER",
                        device.c_str());

  CameraFault fault = camera_fault(CameraState::absent, "no camera is %.80s", device.c_str());
  for (const std::string& name : node_names(folders.classes)) {
    if (by_serial && serial_of(folders.classes + "/" + name) != wanted) continue;
    FoundCamera candidate;
    const CameraFault trouble = open_node(calls, folders.nodes + "/" + name, candidate);
    if (trouble) {
      // Of nodes for metadata and output nobody wants to hear.
      const bool known = !candidate.node.empty();
      if (!known && (by_serial || trouble.state == CameraState::failed)) fault = trouble;
      continue;
    }
    if (by_serial || candidate.bus == wanted) {
      found = candidate;
      return {};
    }
    calls.close(candidate.descriptor);
  }
  return fault;
}

}  // namespace aspect
