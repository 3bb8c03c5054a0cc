#include "tests/runtime/capture/fake_kernel.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>

namespace aspect {

void FakeKernel::later(std::chrono::milliseconds when, std::function<void()> action) {
  actions_.push_back({time + when, std::move(action)});
  std::ranges::stable_sort(actions_, {}, &Action::when);
}

FakeKernel::Time FakeKernel::next_change(Time until) const {
  if (!actions_.empty()) until = std::min(until, actions_.front().when);
  for (const auto& [descriptor, camera] : open_)
    if (camera->streaming) until = std::min(until, camera->next_frame);
  return until;
}

void FakeKernel::advance(Time until) {
  while (time < until) {
    time = std::max(time, next_change(until));
    while (!actions_.empty() && actions_.front().when <= time) {
      const auto action = std::move(actions_.front().what);
      actions_.pop_front();
      action();
    }
    for (const auto& [descriptor, camera] : open_)
      while (camera->streaming && camera->next_frame <= time)
        fake_frame(*camera, camera->next_frame);
  }
}

short FakeKernel::ready(const FakeCamera& camera) const {
  if (camera.disconnected || camera.unplugged) return POLLERR | POLLHUP | POLLPRI;
  short events = 0;
  if (camera.broken || !camera.streaming) events |= POLLERR;
  if (camera.event && camera.subscribed) events |= POLLPRI;
  if (!camera.done.empty()) events |= POLLIN;
  return events;
}

void FakeKernel::poll(std::span<pollfd> descriptors, Time until) noexcept {
  ++polls;
  for (;;) {
    bool any = false;
    for (pollfd& wanted : descriptors) {
      wanted.revents = 0;
      if (wanted.fd < 0) continue;
      const auto found = open_.find(wanted.fd);
      if (found != open_.end())
        wanted.revents = ready(*found->second);
      else if (wanted.fd == wake_descriptor)
        wanted.revents = awake ? POLLIN : 0;
      else
        wanted.revents = POLLNVAL;
      any = any || wanted.revents != 0;
    }
    if (any || time >= until) return;
    advance(next_change(until));
  }
}

int FakeKernel::open(const char* path) noexcept {
  ++opens;
  if (const auto error = open_errors.find(path); error != open_errors.end()) return -error->second;
  const auto found = nodes.find(path);
  if (found == nodes.end()) return -ENOENT;
  if (found->second->disconnected || found->second->unplugged) return -ENODEV;
  open_[next_descriptor_] = found->second;
  ++found->second->descriptors;
  return next_descriptor_++;
}

void FakeKernel::close(int descriptor) noexcept {
  const auto found = open_.find(descriptor);
  if (found == open_.end()) std::abort();  // closed twice
  FakeCamera& camera = *found->second;
  open_.erase(found);
  if (--camera.descriptors > 0) return;
  camera.disconnected = camera.streaming = camera.broken = camera.subscribed = false;
  camera.buffers.clear();
  camera.queued.clear();
  camera.done.clear();
}

int FakeKernel::ioctl(int descriptor, unsigned long request, void* argument) noexcept {
  ++ioctls;
  const auto found = open_.find(descriptor);
  if (found == open_.end()) return EBADF;
  FakeCamera& camera = *found->second;
  if (camera.disconnected || camera.unplugged) return ENODEV;
  if (const auto errors = camera.errors.find(request);
      errors != camera.errors.end() && !errors->second.empty()) {
    const int error = errors->second.front();
    errors->second.pop_front();
    if (error != 0) return error;
  }
  if (request == VIDIOC_STREAMON) camera.next_frame = time + std::chrono::milliseconds(20);
  return fake_ioctl(camera, request, argument);
}

// Offsets are made of buffer and plane.
std::uint8_t* FakeKernel::map(int descriptor, std::size_t bytes, std::uint32_t offset) noexcept {
  const auto found = open_.find(descriptor);
  if (found == open_.end()) return nullptr;
  const std::size_t index = offset >> 16U, plane = offset >> 12U & 0xFU;
  if (index >= found->second->buffers.size() || plane > 1) return nullptr;
  auto& memory = found->second->buffers[index].memory[plane];
  if (bytes > memory.size()) return nullptr;
  ++maps;
  return memory.data();
}

void FakeKernel::unmap(std::uint8_t*, std::size_t) noexcept {
  --maps;
}

}  // namespace aspect
