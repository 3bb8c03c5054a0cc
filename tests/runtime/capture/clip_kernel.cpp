#include "tests/runtime/capture/clip_kernel.h"

#include <algorithm>
#include <cstring>

namespace aspect {

// Up to now; the frames that came get their pictures by their numbers.
void ClipKernel::advance() {
  kernel_.advance(now());
  for (const std::uint32_t index : camera_.done) {
    FakeCamera::Buffer& buffer = camera_.buffers[index];
    if (buffer.done.sequence < painted_) continue;
    painted_ = buffer.done.sequence + 1;
    std::vector<std::uint8_t>& memory = buffer.memory[0];
    const std::size_t frames = clip_.size() / memory.size();
    if (frames == 0) continue;
    std::memcpy(memory.data(), clip_.data() + buffer.done.sequence % frames * memory.size(),
                memory.size());
  }
}

int ClipKernel::open(const char* path) noexcept {
  const std::lock_guard lock(mutex_);
  if (kernel_.time < now() - std::chrono::hours(1)) kernel_.time = now();
  const int descriptor = kernel_.open(path);
  return descriptor < 0 ? descriptor : descriptor + kFirst;
}

void ClipKernel::close(int descriptor) noexcept {
  const std::lock_guard lock(mutex_);
  kernel_.close(descriptor - kFirst);
}

int ClipKernel::ioctl(int descriptor, unsigned long request, void* argument) noexcept {
  const std::lock_guard lock(mutex_);
  advance();
  return kernel_.ioctl(descriptor - kFirst, request, argument);
}

void ClipKernel::poll(std::span<pollfd> descriptors, Time until) noexcept {
  for (;;) {
    std::vector<pollfd> own, others;
    for (const pollfd& each : descriptors)
      (each.fd >= kFirst ? own : others).push_back({each.fd, each.events, 0});
    Time wake = until;
    bool any = false;
    {
      const std::lock_guard lock(mutex_);
      advance();
      for (pollfd& each : own) each.fd -= kFirst;
      kernel_.poll(own, kernel_.time);
      if (camera_.streaming) wake = std::min(wake, camera_.next_frame);
      for (pollfd& each : descriptors) {
        each.revents = 0;
        for (const pollfd& seen : own)
          if (each.fd == seen.fd + kFirst) each.revents = seen.revents;
        any = any || each.revents != 0;
      }
    }
    const auto rest = std::chrono::ceil<std::chrono::milliseconds>(wake - now());
    const int wait_ms = any ? 0 : std::max(0, static_cast<int>(rest.count()));
    if (::poll(others.data(), others.size(), wait_ms) > 0)
      for (const pollfd& seen : others)
        for (pollfd& each : descriptors)
          if (each.fd == seen.fd && seen.revents != 0) each.revents = seen.revents, any = true;
    if (any || now() >= until) return;
  }
}

std::uint8_t* ClipKernel::map(int descriptor, std::size_t bytes, std::uint32_t offset) noexcept {
  const std::lock_guard lock(mutex_);
  return kernel_.map(descriptor - kFirst, bytes, offset);
}

void ClipKernel::unmap(std::uint8_t* memory, std::size_t bytes) noexcept {
  const std::lock_guard lock(mutex_);
  kernel_.unmap(memory, bytes);
}

}  // namespace aspect
