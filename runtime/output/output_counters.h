// What the outputs' threads count.
#pragma once

#include <atomic>
#include <cstdint>

namespace aspect {

struct OutputCounters {
  std::atomic<std::uint64_t> readers{0}, readers_dropped{0}, readers_refused{0};
  std::atomic<std::uint64_t> lines_lost{0};
  std::atomic<bool> standard_output_closed{false};
};

}  // namespace aspect
