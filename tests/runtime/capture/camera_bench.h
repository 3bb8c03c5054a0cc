// A camera on a kernel in memory, and what it has reported.
#pragma once

#include <catch2/catch.hpp>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "runtime/capture/camera.h"
#include "runtime/capture/camera_search.h"
#include "tests/runtime/capture/fake_kernel.h"

namespace aspect {

inline constexpr const char* kNode = "/dev/video0";

struct CameraBench {
  FakeCamera device;
  FakeKernel kernel;
  Camera camera;
  std::vector<CameraEvent> changes;
  std::vector<std::string> reasons;

  explicit CameraBench(CameraSettings settings = {}) : camera(settings, kernel, DeviceFolders{}) {
    kernel.nodes[kNode] = &device;
  }

  CameraEvent next(std::chrono::milliseconds timeout = std::chrono::milliseconds(5000)) {
    const CameraEvent event = camera.next(timeout, kernel.wake_descriptor);
    if (event.kind == CameraEvent::Kind::changed) {
      changes.push_back(event);
      reasons.emplace_back(event.reason);
    }
    return event;
  }
  // The next event that is a frame.
  CameraEvent frame() {
    for (int k = 0; k < 200; ++k)
      if (const CameraEvent event = next(); event.kind == CameraEvent::Kind::frame) return event;
    FAIL("no frame comes");
    return {};
  }
  // Everything that happens within a time; how many frames.
  int run(std::chrono::milliseconds duration) {
    const auto end = kernel.time + duration;
    int frames = 0;
    while (kernel.time < end) {
      const auto rest = std::chrono::ceil<std::chrono::milliseconds>(end - kernel.time);
      frames += next(rest).kind == CameraEvent::Kind::frame ? 1 : 0;
    }
    return frames;
  }
  void make_hdmi() {
    device.has_inputs = device.digital_video = true;
    device.source.width = device.timings.width = 640;
    device.source.height = device.timings.height = 480;
    device.source.pixelclock = device.timings.pixelclock = 25'175'000;
  }
};

inline std::vector<CameraState> states(const CameraBench& bench) {
  std::vector<CameraState> result;
  for (const CameraEvent& event : bench.changes) result.push_back(event.state);
  return result;
}

using States = std::vector<CameraState>;
inline constexpr auto kStreaming = CameraState::streaming;

// `cause` lasts for three seconds of a running stream.
inline void check_recovery(CameraBench& bench, CameraState expected,
                           const std::function<void()>& cause, const std::function<void()>& end) {
  bench.frame();
  cause();
  const auto ends_at = bench.kernel.time + std::chrono::milliseconds(3000);
  bench.kernel.later(std::chrono::milliseconds(3000), end);
  bench.run(std::chrono::milliseconds(2990));
  CHECK(states(bench) == States{kStreaming, expected});
  const CameraEvent back = bench.frame();
  CHECK(bench.kernel.time >= ends_at);
  CHECK(bench.kernel.time - ends_at <= std::chrono::milliseconds(2000));
  CHECK(states(bench) == States{kStreaming, expected, kStreaming});
  CHECK(back.state == kStreaming);
  CHECK(back.reason.empty());
  CHECK(bench.run(std::chrono::milliseconds(1000)) >= 28);
  CHECK(bench.reasons[1] != "");
}

}  // namespace aspect
