// Where the loop leaves its newest frame for who looks at it. The loop never waits for them.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>

#include "runtime/workbench/frame_copy.h"

namespace aspect {

class FrameSlot {
 public:
  // ---- the loop's side: no waiting, no allocation
  // Somebody asked in the last 2 seconds.
  bool wanted() const noexcept;
  // Nothing happens where the slot is just being emptied, or its memory is too small as yet.
  void show(const Frame& frame, const Recognition& recognition,
            std::span<const CameraModel> cameras, std::uint64_t line) noexcept;

  // ---- the other side, one at a time
  // The newest frame by exchange of the memory of both; false where there is none since the last
  // call.
  bool take(FrameCopy& copy, std::uint64_t& line);
  // What is in it is of no use any more.
  void empty();

  // Returns when something is shown, or told here, or the time is over.
  void wait(std::chrono::milliseconds longest);
  void tell_news() noexcept { news_.notify_all(); }

 private:
  using Clock = std::chrono::steady_clock;

  std::atomic<Clock::rep> asked_{0};
  std::atomic<std::size_t> needed_bytes_{0};
  std::mutex mutex_;  // of what follows; the loop only ever tries it
  FrameCopy copy_;
  std::uint64_t line_ = 0;
  bool full_ = false;
  std::mutex waiting_;
  std::condition_variable news_;
};

}  // namespace aspect
