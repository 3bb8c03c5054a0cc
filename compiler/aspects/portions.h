// Independent tasks on all threads, in portions, so that what they make is kept on disk while it is
// fresh and a wish to stop is heard soon.
#pragma once

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "compiler/store/done.h"
#include "runtime/base/result.h"

namespace aspect {

// A fifth of a second: with the store's own delay a kill costs less than a second of work.
inline constexpr std::chrono::milliseconds kPortionTime{200};

// The size of the portion after one of that size that took that long. A portion smaller than the
// number of threads would leave some idle.
inline std::size_t next_portion(std::size_t size, std::chrono::nanoseconds took,
                                std::size_t threads) {
  if (took < kPortionTime / 2) return 2 * size;
  if (took > kPortionTime) return std::max(size / 2, threads);
  return size;
}

// work(i) for every i below count, many at once; then, on the calling thread and in order,
// keep(i) for those that were done, and show(done). When `stop` is set no work is begun any more,
// but what was done is kept. No result depends on the size of the portions.
template <typename Work, typename Keep, typename Show>
Result<Done> run_in_portions(std::size_t count, const std::atomic<bool>* stop, const Work& work,
                             const Keep& keep, const Show& show) {
  const auto stopped = [stop] { return stop != nullptr && stop->load(); };
  const std::size_t threads =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  std::size_t portion = 8 * threads;
  for (std::size_t first = 0; first < count && !stopped();) {
    const auto start = std::chrono::steady_clock::now();
    const std::size_t end = std::min(first + portion, count);
    std::vector<std::uint8_t> done(end - first, 0);
    tbb::parallel_for(first, end, [&](std::size_t i) {
      if (stopped()) return;
      work(i);
      done[i - first] = 1;
    });
    for (std::size_t i = first; i < end; ++i) {
      if (done[i - first] == 0) continue;
      if (Result<Done> kept = keep(i); !kept) return kept;
    }
    show(end);
    portion = next_portion(portion, std::chrono::steady_clock::now() - start, threads);
    first = end;
  }
  return Done{};
}

}  // namespace aspect
