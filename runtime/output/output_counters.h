// What the outputs' threads count.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>

#include "runtime/output/line_ring.h"

namespace aspect {

struct OutputCounters {
  std::atomic<std::uint64_t> readers{0}, readers_dropped{0}, readers_refused{0};
  std::atomic<std::uint64_t> lines_lost{0};
  std::atomic<bool> standard_output_closed{false};
};

// For a reader that may not be dropped and whose line `next` is gone: goes on where the ring says,
// and counts what is missing.
inline void skip_lost(const LineRing& ring, std::uint64_t& next, OutputCounters& counters) {
  const std::uint64_t restart = std::max(ring.restart(), next + 1);
  counters.lines_lost += restart - next;
  next = restart;
}

}  // namespace aspect
