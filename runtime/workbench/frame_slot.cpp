#include "runtime/workbench/frame_slot.h"

#include <utility>

namespace aspect {
namespace {

constexpr std::chrono::seconds kInterest{2};

}  // namespace

bool FrameSlot::wanted() const noexcept {
  const Clock::time_point asked{Clock::duration{asked_.load(std::memory_order_relaxed)}};
  return asked != Clock::time_point{} && Clock::now() - asked < kInterest;
}

void FrameSlot::show(const Frame& frame, const Recognition& recognition,
                     std::span<const CameraModel> cameras, std::uint64_t line) noexcept {
  needed_bytes_.store(FrameCopy::bytes_of(frame), std::memory_order_relaxed);
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock.owns_lock() || !copy_.copy(frame)) return;
  copy_.copy_poses(recognition, cameras);
  line_ = line;
  full_ = true;
  news_.notify_all();
}

bool FrameSlot::take(FrameCopy& copy, std::uint64_t& line) {
  asked_.store(Clock::now().time_since_epoch().count(), std::memory_order_relaxed);
  const std::size_t needed = needed_bytes_.load(std::memory_order_relaxed);
  const std::lock_guard lock(mutex_);
  const bool full = std::exchange(full_, false);
  if (full) {
    std::swap(copy, copy_);
    line = line_;
  }
  copy_.make_room(needed);
  return full;
}

void FrameSlot::empty() {
  const std::lock_guard lock(mutex_);
  full_ = false;
}

void FrameSlot::wait(std::chrono::milliseconds longest) {
  std::unique_lock lock(waiting_);
  news_.wait_for(lock, longest);
}

}  // namespace aspect
