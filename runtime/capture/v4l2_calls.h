// Everything that a camera asks of the kernel, so that tests can stand in for it.
#pragma once

#include <poll.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

namespace aspect {

class V4l2Calls {
 public:
  using Time = std::chrono::steady_clock::time_point;

  virtual ~V4l2Calls() = default;

  // Not blocking, read and write. A descriptor, or -errno.
  virtual int open(const char* path) noexcept = 0;
  virtual void close(int descriptor) noexcept = 0;

  // 0 or errno; begun again where a signal came in between.
  virtual int ioctl(int descriptor, unsigned long request, void* argument) noexcept = 0;

  // Waits until `until` at the latest and fills in revents. Returns early, with no revents, when a
  // signal comes.
  virtual void poll(std::span<pollfd> descriptors, Time until) noexcept = 0;

  // Shared, for reading and writing; null where it cannot be had.
  virtual std::uint8_t* map(int descriptor, std::size_t bytes, std::uint32_t offset) noexcept = 0;
  virtual void unmap(std::uint8_t* memory, std::size_t bytes) noexcept = 0;

  // CLOCK_MONOTONIC, the clock that drivers stamp frames with.
  virtual Time now() noexcept = 0;
};

// The kernel that this runs on.
V4l2Calls& kernel_calls();

}  // namespace aspect
