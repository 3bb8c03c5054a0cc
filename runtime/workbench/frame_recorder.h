// Frames in a row, as the camera gave them, into files of a folder.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/workbench/frame_copy.h"

namespace aspect {

struct Recorded {
  std::filesystem::path first, last;
  int frames = 0;
};

class FrameRecorder {
 public:
  static constexpr int kFrames = 10;

  // ---- the loop's side: no waiting, no allocation
  bool wanted() const noexcept { return wanted_.load(std::memory_order_acquire); }
  void show(const Frame& frame) noexcept;

  // ---- the other side, one at a time
  // The next kFrames frames, or those that come within `patience`; an error where there are none.
  // Named frame_NNNNNN, from the number on that follows the largest one there: nothing is ever
  // overwritten. Camera formats are kept as they are, in files that aspect-replay reads; colours,
  // grey values and depths as PPM and PGM.
  [[nodiscard]] Result<Recorded> record(const std::filesystem::path& folder,
                                        std::chrono::milliseconds patience);

 private:
  void collect(std::chrono::milliseconds patience);

  std::atomic<bool> wanted_{false};
  std::atomic<std::size_t> needed_bytes_{0};
  std::mutex mutex_;  // of what follows; the loop only ever tries it
  std::vector<FrameCopy> copies_;
  std::size_t count_ = 0;
  std::mutex waiting_;
  std::condition_variable news_;
};

}  // namespace aspect
