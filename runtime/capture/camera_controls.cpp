#include "runtime/capture/camera_controls.h"

#include <linux/videodev2.h>

#include <algorithm>
#include <cerrno>
#include <string_view>

#include "runtime/base/nearest_word.h"
#include "runtime/capture/camera_control_list.h"

namespace aspect {
namespace {

std::string unknown_line(const std::string& name, std::span<const KnownControl> known) {
  std::vector<std::string_view> names;
  for (const KnownControl& control : known) names.push_back(control.name);
  const std::string_view near = nearest_word(name, names);
  std::string line = "the camera has no control " + name;
  if (!near.empty()) line += "; did you mean " + std::string(near) + "?";
  return line;
}

// A value that the driver's limits allow.
std::int64_t within_limits(const CameraControl& wanted, const v4l2_query_ext_ctrl& query,
                           std::vector<std::string>& warnings) {
  if (query.type == V4L2_CTRL_TYPE_BUTTON) return wanted.value;
  const bool mask = query.type == V4L2_CTRL_TYPE_BITMASK;
  const std::int64_t least = mask ? 0 : query.minimum;
  const std::int64_t most =
      mask ? std::int64_t{static_cast<std::uint32_t>(query.maximum)} : query.maximum;
  if (least > most || (wanted.value >= least && wanted.value <= most)) return wanted.value;
  warnings.push_back(wanted.name + " goes from " + std::to_string(least) + " to " +
                     std::to_string(most) + ", and " + std::to_string(wanted.value) +
                     " is not among it");
  return std::clamp(wanted.value, least, most);
}

// What can be said about a control before it is touched; empty: nothing.
const char* obstacle(const v4l2_query_ext_ctrl& query) {
  if (!is_number_control(query.type) || query.nr_of_dims != 0)
    return "is not a number and stays as it is";
  if ((query.flags & V4L2_CTRL_FLAG_READ_ONLY) != 0) return "can only be read";
  if ((query.flags & V4L2_CTRL_FLAG_GRABBED) != 0) return "is held by another program";
  return nullptr;
}

struct SetControl {
  const CameraControl* wanted;
  v4l2_query_ext_ctrl query;
  std::int64_t value;  // that was set
  bool refused;
};

void read_back(V4l2Calls& calls, int descriptor, const SetControl& control,
               std::vector<std::string>& values, std::vector<std::string>& warnings) {
  const std::string& name = control.wanted->name;
  if (control.query.type == V4L2_CTRL_TYPE_BUTTON) return;
  v4l2_query_ext_ctrl query{};
  query.id = control.query.id;
  if (calls.ioctl(descriptor, VIDIOC_QUERY_EXT_CTRL, &query) == 0 &&
      (query.flags & V4L2_CTRL_FLAG_INACTIVE) != 0)
    warnings.push_back(name + " has no effect now: switch off, before it, the automatic above it");
  if ((control.query.flags & V4L2_CTRL_FLAG_WRITE_ONLY) != 0) return;
  std::int64_t value = 0;
  if (transfer_control(calls, descriptor, control.query, false, value) != 0) {
    warnings.push_back(name + " cannot be read back");
    return;
  }
  values.push_back(name + " = " + std::to_string(value));
  if (!control.refused && value != control.value)
    warnings.push_back(name + " is " + std::to_string(value) + ", not " +
                       std::to_string(control.value));
}

// As long as the node is open, the kernel refuses what others want to change.
void lock_settings(V4l2Calls& calls, int descriptor, std::vector<std::string>& warnings) {
  std::uint32_t priority = V4L2_PRIORITY_RECORD;
  if (calls.ioctl(descriptor, VIDIOC_S_PRIORITY, &priority) != 0)
    warnings.emplace_back("the driver has no lock: other programs can change the controls");
}

}  // namespace

CameraFault set_controls(V4l2Calls& calls, int descriptor, std::span<const CameraControl> controls,
                         std::vector<std::string>& values, std::vector<std::string>& warnings) {
  if (controls.empty()) return {};
  lock_settings(calls, descriptor, warnings);
  const std::vector<KnownControl> known = list_controls(calls, descriptor);
  std::vector<SetControl> set;
  for (const CameraControl& wanted : controls) {
    const auto found = std::ranges::find(known, wanted.name, &KnownControl::name);
    if (found == known.end()) {
      warnings.push_back(unknown_line(wanted.name, known));
      continue;
    }
    if (const char* why = obstacle(found->query)) {
      warnings.push_back(wanted.name + " " + why);
      if (!is_number_control(found->query.type) || found->query.nr_of_dims != 0) continue;
      set.push_back({&wanted, found->query, 0, true});
      continue;
    }
    std::int64_t value = within_limits(wanted, found->query, warnings);
    const std::int64_t asked = value;
    const int error = transfer_control(calls, descriptor, found->query, true, value);
    if (error == ENODEV) return call_fault("VIDIOC_S_CTRL", error);
    if (error != 0)
      warnings.push_back("the camera refuses " + wanted.name + " = " + std::to_string(asked) +
                         ": " + call_fault("VIDIOC_S_CTRL", error).reason.data());
    set.push_back({&wanted, found->query, asked, error != 0});
  }
  for (const SetControl& control : set) read_back(calls, descriptor, control, values, warnings);
  return {};
}

}  // namespace aspect
