// What happens besides frames as lines of JSON.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace aspect {

// {"state": "absent", "camera": "/dev/video0", "reason": "...", "time_s": 1.5}, without a reason
// where it is empty. Returns the line's length, its end included; 0: it does not fit.
std::size_t write_state_json(std::string_view state, std::string_view camera,
                             std::string_view reason, double time_s, std::span<char> out) noexcept;

}  // namespace aspect
