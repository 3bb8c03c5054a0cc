#include "runtime/capture/v4l2_calls.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>

namespace aspect {
namespace {

class Kernel final : public V4l2Calls {
 public:
  int open(const char* path) noexcept override {
    int descriptor;
    do descriptor = ::open(path, O_RDWR | O_NONBLOCK | O_CLOEXEC);
    while (descriptor < 0 && errno == EINTR);
    return descriptor < 0 ? -errno : descriptor;
  }

  // Linux frees the descriptor even where close is interrupted.
  void close(int descriptor) noexcept override { ::close(descriptor); }

  int ioctl(int descriptor, unsigned long request, void* argument) noexcept override {
    int status;
    do status = ::ioctl(descriptor, request, argument);
    while (status < 0 && errno == EINTR);
    return status < 0 ? errno : 0;
  }

  void poll(std::span<pollfd> descriptors, Time until) noexcept override {
    for (pollfd& descriptor : descriptors) descriptor.revents = 0;
    const auto wait = std::chrono::ceil<std::chrono::milliseconds>(until - now()).count();
    const auto wait_ms = static_cast<int>(std::clamp<std::int64_t>(wait, 0, INT_MAX));
    if (::poll(descriptors.data(), descriptors.size(), wait_ms) < 0)
      for (pollfd& descriptor : descriptors) descriptor.revents = 0;
  }

  // With 64 bits on every machine: offsets of a buffer go up to 2^32.
  std::uint8_t* map(int descriptor, std::size_t bytes, std::uint32_t offset) noexcept override {
    void* memory =
        ::mmap64(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, off64_t{offset});
    return memory == MAP_FAILED ? nullptr : static_cast<std::uint8_t*>(memory);
  }
  void unmap(std::uint8_t* memory, std::size_t bytes) noexcept override { ::munmap(memory, bytes); }

  Time now() noexcept override { return std::chrono::steady_clock::now(); }
};

}  // namespace

V4l2Calls& kernel_calls() {
  static Kernel kernel;
  return kernel;
}

}  // namespace aspect
