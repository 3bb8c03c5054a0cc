#include "runtime/capture/v4l2_text.h"

#include <linux/videodev2.h>

#include <algorithm>

namespace aspect {

std::string v4l2_text(const void* text, std::size_t size) {
  const auto* bytes = static_cast<const char*>(text);
  std::string result(bytes, std::find(bytes, bytes + size, '\0'));
  for (char& c : result)
    if (c < ' ' || c > '~') c = '?';
  return result;
}

std::string fourcc_text(std::uint32_t fourcc) {
  const std::uint32_t little_endian = fourcc & 0x7FFFFFFFU;
  const char bytes[] = {
      static_cast<char>(little_endian & 0xFFU), static_cast<char>(little_endian >> 8U & 0xFFU),
      static_cast<char>(little_endian >> 16U & 0xFFU), static_cast<char>(little_endian >> 24U)};
  std::string result = v4l2_text(bytes);
  while (!result.empty() && result.back() == ' ') result.pop_back();
  return result + (fourcc >> 31U != 0 ? "-BE" : "");
}

std::uint32_t fourcc_of(const std::string& text) {
  if (text.empty() || text.size() > 4) return 0;
  std::string four = text;
  four.resize(4, ' ');
  const auto byte = [&](std::size_t k) {
    return std::uint32_t{static_cast<std::uint8_t>(four[k])};
  };
  return v4l2_fourcc(byte(0), byte(1), byte(2), byte(3));
}

std::string control_name(const std::string& name) {
  std::string result;
  bool gap = false;
  for (const char c : name) {
    const bool upper = c >= 'A' && c <= 'Z';
    if (upper || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
      if (gap && !result.empty()) result += '_';
      result += upper ? static_cast<char>(c - 'A' + 'a') : c;
      gap = false;
    } else {
      gap = true;
    }
  }
  return result;
}

}  // namespace aspect
