// What a driver lets one adjust: its controls, their limits and values.
#pragma once

#include <linux/videodev2.h>

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/capture/v4l2_calls.h"

namespace aspect {

struct KnownControl {
  std::string name;
  v4l2_query_ext_ctrl query{};
};

// All that are not disabled.
std::vector<KnownControl> list_controls(V4l2Calls& calls, int descriptor);

bool is_number_control(std::uint32_t type);

// 0 or errno. `set` puts `value` there; either way it is what the driver says afterwards.
int transfer_control(V4l2Calls& calls, int descriptor, const v4l2_query_ext_ctrl& query, bool set,
                     std::int64_t& value);

struct ControlItem {
  std::int64_t value = 0;
  std::string name;
};

struct AdjustableControl {
  enum class Kind : std::uint8_t { number, truth, menu, button } kind = Kind::number;
  std::string name;
  std::int64_t least = 0, most = 0, step = 1, usual = 0, value = 0;
  bool inactive = false;           // an automatic decides
  bool fixed = false;              // cannot be set
  std::vector<ControlItem> items;  // of a menu
};

// Those that are numbers, with what they are now.
std::vector<AdjustableControl> list_adjustable(V4l2Calls& calls, int descriptor);

}  // namespace aspect
