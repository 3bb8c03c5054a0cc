// Minima, maxima and masks of bytes alone, into rows that alias nothing: compilers turn these loops
// into vector code of 16 pixels a step. With branches, or outputs that might overlap inputs, they
// took ten times as long, three quarters of a camera frame.
#include "runtime/vision/alike_rows.h"

#include <algorithm>

namespace aspect {
namespace {

using Byte = std::uint8_t;

inline Byte difference(Byte a, Byte b) {
  return static_cast<Byte>(std::max(a, b) - std::min(a, b));
}

// 255 where two pixels are alike.
inline Byte alike(const ShareRow& a, const ShareRow& b, std::size_t i, Byte intensity_step) {
  const Byte step =
      std::max(std::max(difference(a.red[i], b.red[i]), difference(a.green[i], b.green[i])),
               difference(a.blue[i], b.blue[i]));
  const Byte allowed = std::max(a.tolerance[i], b.tolerance[i]);
  const Byte colour = step <= allowed ? Byte{255} : Byte{0};
  const Byte level =
      difference(a.intensity[i], b.intensity[i]) <= intensity_step ? Byte{255} : Byte{0};
  return colour & level;
}

}  // namespace

void require_alike(ShareRow a, ShareRow b, std::size_t count, Byte intensity_step,
                   Byte* __restrict core) {
  for (std::size_t i = 0; i < count; ++i) {
    const Byte both = a.foreground[i] & b.foreground[i];
    core[i] = static_cast<Byte>(core[i] & (alike(a, b, i, intensity_step) | ~both));
  }
}

void link_alike(ShareRow a, ShareRow b, const Byte* core_a, const Byte* core_b, std::size_t count,
                Byte intensity_step, Byte* __restrict link) {
  for (std::size_t i = 0; i < count; ++i)
    link[i] = alike(a, b, i, intensity_step) & core_a[i] & core_b[i];
}

}  // namespace aspect
