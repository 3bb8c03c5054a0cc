#include "runtime/capture/camera_control_list.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "runtime/capture/v4l2_text.h"

namespace aspect {
namespace {

constexpr int kMaxControls = 1024;

// As an older kernel knows it.
int query_old(V4l2Calls& calls, int descriptor, v4l2_query_ext_ctrl& query) {
  v4l2_queryctrl old{};
  old.id = query.id;
  const int error = calls.ioctl(descriptor, VIDIOC_QUERYCTRL, &old);
  if (error != 0) return error;
  query = {};
  query.id = old.id;
  query.type = old.type;
  std::memcpy(query.name, old.name, sizeof old.name);
  query.minimum = old.minimum;
  query.maximum = old.maximum;
  query.step = static_cast<__u64>(std::max(old.step, 0));
  query.default_value = old.default_value;
  query.flags = old.flags;
  return 0;
}

int transfer_wide(V4l2Calls& calls, int descriptor, unsigned long request, std::uint32_t id,
                  std::int64_t& value) {
  v4l2_ext_control control{};
  control.id = id;
  control.value64 = value;
  v4l2_ext_controls all{};
  all.which = V4L2_CTRL_ID2WHICH(id);
  all.count = 1;
  all.controls = &control;
  const int error = calls.ioctl(descriptor, request, &all);
  value = control.value64;
  return error;
}

std::vector<ControlItem> items_of(V4l2Calls& calls, int descriptor,
                                  const v4l2_query_ext_ctrl& query) {
  constexpr std::int64_t kMostItems = 256;
  std::vector<ControlItem> items;
  const bool numbers = query.type == V4L2_CTRL_TYPE_INTEGER_MENU;
  const std::int64_t end = std::min<std::int64_t>(query.maximum, query.minimum + kMostItems);
  for (std::int64_t value = query.minimum; value <= end; ++value) {
    v4l2_querymenu item{};
    item.id = query.id;
    item.index = static_cast<std::uint32_t>(value);
    if (calls.ioctl(descriptor, VIDIOC_QUERYMENU, &item) != 0) continue;
    items.push_back({value, numbers ? std::to_string(item.value) : v4l2_text(item.name)});
  }
  return items;
}

AdjustableControl::Kind kind_of(std::uint32_t type) {
  switch (type) {
    case V4L2_CTRL_TYPE_BOOLEAN:
      return AdjustableControl::Kind::truth;
    case V4L2_CTRL_TYPE_MENU:
    case V4L2_CTRL_TYPE_INTEGER_MENU:
      return AdjustableControl::Kind::menu;
    case V4L2_CTRL_TYPE_BUTTON:
      return AdjustableControl::Kind::button;
    default:
      return AdjustableControl::Kind::number;
  }
}

}  // namespace

std::vector<KnownControl> list_controls(V4l2Calls& calls, int descriptor) {
  std::vector<KnownControl> known;
  std::uint32_t last = 0;
  for (int k = 0; k < kMaxControls; ++k) {
    KnownControl control;
    control.query.id = last | V4L2_CTRL_FLAG_NEXT_CTRL;
    int error = calls.ioctl(descriptor, VIDIOC_QUERY_EXT_CTRL, &control.query);
    if (error == ENOTTY) {
      control.query = {};
      control.query.id = last | V4L2_CTRL_FLAG_NEXT_CTRL;
      error = query_old(calls, descriptor, control.query);
    }
    if (error != 0 || control.query.id <= last) break;
    last = control.query.id;
    if (control.query.type == V4L2_CTRL_TYPE_CTRL_CLASS ||
        (control.query.flags & V4L2_CTRL_FLAG_DISABLED) != 0)
      continue;
    control.name = control_name(v4l2_text(control.query.name));
    known.push_back(std::move(control));
  }
  return known;
}

bool is_number_control(std::uint32_t type) {
  switch (type) {
    case V4L2_CTRL_TYPE_INTEGER:
    case V4L2_CTRL_TYPE_BOOLEAN:
    case V4L2_CTRL_TYPE_MENU:
    case V4L2_CTRL_TYPE_BUTTON:
    case V4L2_CTRL_TYPE_INTEGER64:
    case V4L2_CTRL_TYPE_BITMASK:
    case V4L2_CTRL_TYPE_INTEGER_MENU:
      return true;
    default:
      return false;
  }
}

int transfer_control(V4l2Calls& calls, int descriptor, const v4l2_query_ext_ctrl& query, bool set,
                     std::int64_t& value) {
  if (query.type == V4L2_CTRL_TYPE_INTEGER64)
    return transfer_wide(calls, descriptor, set ? VIDIOC_S_EXT_CTRLS : VIDIOC_G_EXT_CTRLS, query.id,
                         value);
  const bool mask = query.type == V4L2_CTRL_TYPE_BITMASK;
  v4l2_control control{};
  control.id = query.id;
  control.value = static_cast<std::int32_t>(value);
  const int error = calls.ioctl(descriptor, set ? VIDIOC_S_CTRL : VIDIOC_G_CTRL, &control);
  value = mask ? std::int64_t{static_cast<std::uint32_t>(control.value)} : control.value;
  return error;
}

std::vector<AdjustableControl> list_adjustable(V4l2Calls& calls, int descriptor) {
  std::vector<AdjustableControl> all;
  for (const KnownControl& known : list_controls(calls, descriptor)) {
    const v4l2_query_ext_ctrl& query = known.query;
    if (!is_number_control(query.type) || query.nr_of_dims != 0) continue;
    AdjustableControl control;
    control.name = known.name;
    control.kind = kind_of(query.type);
    control.least = query.minimum;
    control.most = query.type == V4L2_CTRL_TYPE_BITMASK
                       ? std::int64_t{static_cast<std::uint32_t>(query.maximum)}
                       : query.maximum;
    control.step = std::max<std::int64_t>(1, static_cast<std::int64_t>(query.step));
    control.usual = query.default_value;
    control.value = query.default_value;
    control.inactive = (query.flags & V4L2_CTRL_FLAG_INACTIVE) != 0;
    control.fixed = (query.flags & (V4L2_CTRL_FLAG_READ_ONLY | V4L2_CTRL_FLAG_GRABBED)) != 0;
    if (control.kind == AdjustableControl::Kind::menu)
      control.items = items_of(calls, descriptor, query);
    if (control.kind != AdjustableControl::Kind::button &&
        (query.flags & V4L2_CTRL_FLAG_WRITE_ONLY) == 0)
      transfer_control(calls, descriptor, query, false, control.value);
    all.push_back(std::move(control));
  }
  return all;
}

}  // namespace aspect
