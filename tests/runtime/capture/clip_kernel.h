// A camera that plays a recorded clip on the machine's own clock, behind the calls of a kernel:
// frames come when they are due, whoever is ready for them, and are lost where nobody is.
#pragma once

#include <mutex>
#include <vector>

#include "tests/runtime/capture/fake_kernel.h"

namespace aspect {

class ClipKernel final : public V4l2Calls {
 public:
  // Frames of the camera's format, one after the other without gaps, over and over.
  ClipKernel(FakeCamera& camera, std::vector<std::uint8_t> clip)
      : camera_(camera), clip_(std::move(clip)) {
    kernel_.nodes["/dev/video0"] = &camera;
  }

  int open(const char* path) noexcept override;
  void close(int descriptor) noexcept override;
  int ioctl(int descriptor, unsigned long request, void* argument) noexcept override;
  // Other descriptors than its own are the machine's.
  void poll(std::span<pollfd> descriptors, Time until) noexcept override;
  std::uint8_t* map(int descriptor, std::size_t bytes, std::uint32_t offset) noexcept override;
  void unmap(std::uint8_t* memory, std::size_t bytes) noexcept override;
  Time now() noexcept override { return std::chrono::steady_clock::now(); }

 private:
  // Far from the numbers that the machine gives.
  static constexpr int kFirst = 1 << 20;
  void advance();

  std::mutex mutex_;  // the page asks for controls from a thread of its own
  FakeCamera& camera_;
  FakeKernel kernel_;
  std::vector<std::uint8_t> clip_;
  std::uint64_t painted_ = 0;
};

}  // namespace aspect
