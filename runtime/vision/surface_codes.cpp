#include "runtime/vision/surface_codes.h"

#include <cmath>

namespace aspect {

bool find_surface_codes(const Frame& frame, const VisionParameters& parameters, Planes& codes,
                        CodeMasks& masks) {
  const Box box = box_of_numbers(frame, parameters, 1, 65535);
  codes.active = box;
  for (int y = box.y; y < box.y + box.height; ++y) {
    for (int x = box.x; x < box.x + box.width; ++x) {
      const auto i = static_cast<std::size_t>(y * codes.stride_px + x);
      const unsigned id = number_at(frame, x, y);
      codes.red[i] = static_cast<std::uint8_t>(id & 0xFFU);
      codes.green[i] = static_cast<std::uint8_t>(id >> 8U);
      codes.blue[i] = 0;
      masks.foreground[i] = masks.solid[i] = id != 0 ? 255 : 0;
    }
  }
  return !box.empty();
}

int surface_id_of(const std::array<float, 3>& code) {
  return static_cast<int>(std::lround(code[0])) + 256 * static_cast<int>(std::lround(code[1]));
}

}  // namespace aspect
