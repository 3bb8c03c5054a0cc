#include <algorithm>
#include <cerrno>
#include <cstring>

#include "tests/runtime/capture/fake_kernel.h"

namespace aspect {
namespace {

FakeControl* control_of(FakeCamera& camera, std::uint32_t id) {
  const auto found = std::ranges::find(camera.controls, id, &FakeControl::id);
  return found == camera.controls.end() ? nullptr : &*found;
}

int query_control(FakeCamera& camera, v4l2_query_ext_ctrl& query) {
  FakeControl* found = nullptr;
  const std::uint32_t id = query.id & ~V4L2_CTRL_FLAG_NEXT_CTRL;
  for (FakeControl& control : camera.controls) {
    const bool next = (query.id & V4L2_CTRL_FLAG_NEXT_CTRL) != 0;
    if ((next ? control.id > id : control.id == id) && (!found || control.id < found->id))
      found = &control;
  }
  if (!found) return EINVAL;
  query = {};
  query.id = found->id;
  query.type = found->type;
  std::memcpy(query.name, found->name.data(), std::min(sizeof query.name, found->name.size()));
  query.minimum = found->least;
  query.maximum = found->most;
  query.step = static_cast<__u64>(found->rounding);
  query.default_value = found->least;
  query.flags = found->flags;
  const FakeControl* automatic = control_of(camera, found->automatic);
  if (automatic && automatic->value != 0) query.flags |= V4L2_CTRL_FLAG_INACTIVE;
  return 0;
}

int query_item(FakeCamera& camera, v4l2_querymenu& item) {
  const FakeControl* control = control_of(camera, item.id);
  if (!control || item.index >= control->items.size() || control->items[item.index].empty())
    return EINVAL;
  const std::string& name = control->items[item.index];
  std::memcpy(item.name, name.data(), std::min(sizeof item.name - 1, name.size()));
  return 0;
}

int transfer(FakeCamera& camera, std::uint32_t id, bool set, std::int64_t& value) {
  FakeControl* control = control_of(camera, id);
  if (!control) return EINVAL;
  if (set && control->refusal != 0) return control->refusal;
  if (set && (control->flags & V4L2_CTRL_FLAG_READ_ONLY) != 0) return EACCES;
  if (set) control->value = value / control->rounding * control->rounding;
  value = control->value;
  return 0;
}

int transfer_one(FakeCamera& camera, v4l2_control& control, bool set) {
  std::int64_t value = control.value;
  const int error = transfer(camera, control.id, set, value);
  control.value = static_cast<std::int32_t>(value);
  return error;
}

int transfer_wide(FakeCamera& camera, v4l2_ext_controls& all, bool set) {
  std::int64_t value = all.controls[0].value64;
  const int error = transfer(camera, all.controls[0].id, set, value);
  all.controls[0].value64 = value;
  return error;
}

int input_ioctl(FakeCamera& camera, unsigned long request, void* argument) {
  if (!camera.has_inputs) return ENOTTY;
  auto& input = *static_cast<v4l2_input*>(argument);
  auto& timings = *static_cast<v4l2_dv_timings*>(argument);
  switch (request) {
    case VIDIOC_G_INPUT:
      *static_cast<int*>(argument) = 1;
      return 0;
    case VIDIOC_ENUMINPUT:
      if (input.index != 1) return EINVAL;
      input.status = camera.input_status;
      input.capabilities = camera.digital_video ? V4L2_IN_CAP_DV_TIMINGS : 0;
      return 0;
    case VIDIOC_QUERY_DV_TIMINGS:
      timings.bt = camera.source;
      return camera.query_error;
    case VIDIOC_G_DV_TIMINGS:
      timings.bt = camera.timings;
      return 0;
    case VIDIOC_S_DV_TIMINGS:
      if (!camera.buffers.empty()) return EBUSY;
      camera.timings = timings.bt;
      return 0;
    default:
      return ENOTTY;
  }
}

int event_ioctl(FakeCamera& camera, unsigned long request, void* argument) {
  if (request == VIDIOC_SUBSCRIBE_EVENT) {
    camera.subscribed |= static_cast<v4l2_event_subscription*>(argument)->id == 1;
    return 0;
  }
  if (!camera.event) return ENOENT;
  camera.event = false;
  static_cast<v4l2_event*>(argument)->type = V4L2_EVENT_SOURCE_CHANGE;
  return 0;
}

}  // namespace

int fake_control_ioctl(FakeCamera& camera, unsigned long request, void* argument) {
  switch (request) {
    case VIDIOC_QUERY_EXT_CTRL:
      return query_control(camera, *static_cast<v4l2_query_ext_ctrl*>(argument));
    case VIDIOC_QUERYMENU:
      return query_item(camera, *static_cast<v4l2_querymenu*>(argument));
    case VIDIOC_S_CTRL:
    case VIDIOC_G_CTRL:
      return transfer_one(camera, *static_cast<v4l2_control*>(argument), request == VIDIOC_S_CTRL);
    case VIDIOC_S_EXT_CTRLS:
    case VIDIOC_G_EXT_CTRLS:
      return transfer_wide(camera, *static_cast<v4l2_ext_controls*>(argument),
                           request == VIDIOC_S_EXT_CTRLS);
    case VIDIOC_S_PRIORITY:
      if (!camera.has_priorities) return ENOTTY;
      camera.priority = *static_cast<std::uint32_t*>(argument);
      return 0;
    case VIDIOC_SUBSCRIBE_EVENT:
    case VIDIOC_DQEVENT:
      return event_ioctl(camera, request, argument);
    default:
      return input_ioctl(camera, request, argument);
  }
}

}  // namespace aspect
