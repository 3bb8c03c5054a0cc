// Texts that come from drivers and devices: perhaps not terminated, perhaps not printable.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace aspect {

// Up to the first zero, every byte that is not printable ASCII as '?'.
std::string v4l2_text(const void* text, std::size_t size);

template <typename Character, std::size_t kSize>
std::string v4l2_text(const Character (&text)[kSize]) {
  static_assert(sizeof(Character) == 1);
  return v4l2_text(text, kSize);
}

// "YUYV"; without the blanks at its end.
std::string fourcc_text(std::uint32_t fourcc);

// Of up to four characters, filled up with blanks; 0 where it is not.
std::uint32_t fourcc_of(const std::string& text);

// "White Balance, Automatic" is white_balance_automatic, as v4l2-ctl names controls.
std::string control_name(const std::string& name);

}  // namespace aspect
