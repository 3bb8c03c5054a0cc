#include <catch2/catch.hpp>
#include <cerrno>

#include "tests/runtime/capture/camera_bench.h"
#include "tests/runtime/service/allocation_count.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;
using std::chrono::milliseconds;
using Kind = CameraEvent::Kind;

TEST_CASE("A camera starts, says what was agreed and sends its frames in order") {
  CameraBench bench;
  const CameraEvent first = bench.next();
  CHECK(first.kind == Kind::changed);
  CHECK(first.state == kStreaming);
  const CameraPlan& plan = bench.camera.plan();
  CHECK(plan.node == kNode);
  CHECK(plan.driver == "fake");
  CHECK(plan.fourcc == "YUYV");
  CHECK(plan.width_px == 640);
  CHECK(plan.rate_hz == 30);
  CHECK(plan.warnings.empty());
  for (std::uint64_t k = 1; k < 300; ++k) {
    const CameraEvent event = bench.next();
    REQUIRE(event.kind == Kind::frame);
    REQUIRE(event.sequence == k);
    REQUIRE(event.lost == 0);
    REQUIRE(event.late == 0);
    REQUIRE(bench.kernel.time - event.captured < std::chrono::microseconds(1));
    REQUIRE(event.frame.format == PixelFormat::yuyv8);
    REQUIRE(event.frame.stride_bytes == 1280);
    REQUIRE(event.frame.data[0] == static_cast<std::uint8_t>(k - 1));
  }
}

TEST_CASE("A frame costs four calls and no memory") {
  CameraBench bench;
  for (int k = 0; k < 10; ++k) bench.frame();
  const int polls = bench.kernel.polls, ioctls = bench.kernel.ioctls;
  const std::size_t allocations = allocation_count();
  for (int k = 0; k < 1000; ++k)
    if (bench.camera.next(milliseconds(1000), -1).kind != Kind::frame) FAIL("no frame");
  CHECK(allocation_count() == allocations);
  CHECK(bench.kernel.polls - polls == 1000);
  CHECK(bench.kernel.ioctls - ioctls == 3000);
}

TEST_CASE("The newest frame is handed out, older ones are counted as late") {
  CameraBench bench;
  bench.frame();
  bench.frame();
  bench.kernel.advance(bench.kernel.time + milliseconds(95));
  const CameraEvent event = bench.next();
  CHECK(event.kind == Kind::frame);
  CHECK(event.late == 1);
  CHECK(event.lost == 0);
  CHECK(event.frame.data[0] == event.sequence - 1);
  // Longer than there are buffers: three wait, the oldest ones, and the rest is lost.
  bench.kernel.advance(bench.kernel.time + milliseconds(1000));
  const CameraEvent waiting = bench.next();
  CHECK(waiting.late == 2);
  const CameraEvent after = bench.next();
  CHECK(after.lost >= 25);
  CHECK(after.sequence == bench.device.produced);
}

TEST_CASE("Gaps in the sequence are lost frames, also where the counter wraps") {
  CameraBench bench;
  bench.device.sequence = 0xFFFFFFF0U;
  bench.frame();
  for (int k = 0; k < 10; ++k) CHECK(bench.frame().lost == 0);
  bench.device.lose_next = 9;
  const CameraEvent gap = bench.frame();
  CHECK(gap.lost == 9);
  CHECK(gap.sequence == 21);
  CHECK(bench.device.sequence < 100);
  for (int k = 0; k < 100; ++k) CHECK(bench.frame().lost == 0);
}

TEST_CASE("Flagged and short frames are damaged, and the stream goes on") {
  CameraBench bench;
  bench.frame();
  bench.device.flag_next = 1;
  CameraEvent event = bench.next();
  CHECK(event.kind == Kind::damaged);
  CHECK(event.state == kStreaming);
  CHECK_THAT(std::string(event.reason), Contains("flags"));
  CHECK(bench.next().kind == Kind::frame);
  bench.device.shorten_next = 2;
  event = bench.next();
  CHECK(event.kind == Kind::damaged);
  CHECK_THAT(std::string(event.reason), Contains("short"));
  CHECK(bench.next().kind == Kind::damaged);
  event = bench.next();
  CHECK(event.kind == Kind::frame);
  CHECK(event.lost == 0);
  CHECK(event.sequence == 6);
  CHECK(states(bench) == States{kStreaming});
}

TEST_CASE("A whole frame that waits behind a damaged one is not forgotten") {
  CameraBench bench;
  bench.frame();
  bench.frame();
  bench.kernel.advance(bench.kernel.time + milliseconds(40));
  bench.device.flag_next = 1;
  bench.kernel.advance(bench.kernel.time + milliseconds(30));
  CHECK(bench.next(milliseconds(0)).kind == Kind::damaged);
  const CameraEvent event = bench.next(milliseconds(0));
  CHECK(event.kind == Kind::frame);
  CHECK(event.late == 0);
}

TEST_CASE("The descriptor to be woken by comes first, in every state") {
  CameraBench bench;
  bench.kernel.wake_descriptor = 77;
  bench.frame();
  bench.kernel.awake = true;
  CHECK(bench.next().kind == Kind::woken);
  bench.kernel.awake = false;
  CHECK(bench.next().kind == Kind::frame);
  bench.kernel.nodes.clear();
  bench.device.unplugged = true;
  CHECK(bench.next().kind == Kind::changed);
  bench.kernel.later(milliseconds(300), [&] { bench.kernel.awake = true; });
  CHECK(bench.next().kind == Kind::woken);
}

TEST_CASE("A call returns when its time is over") {
  CameraBench bench;
  bench.kernel.nodes.clear();
  CHECK(bench.next(milliseconds(0)).kind == Kind::changed);
  const auto begin = bench.kernel.time;
  const CameraEvent event = bench.next(milliseconds(1234));
  CHECK(event.kind == Kind::nothing);
  CHECK(event.state == CameraState::absent);
  CHECK_FALSE(event.reason.empty());
  CHECK(bench.kernel.time - begin == milliseconds(1234));
}

TEST_CASE("Checking a camera streams nothing and leaves nothing open") {
  CameraBench bench;
  const auto plan = bench.camera.check();
  REQUIRE(plan.ok());
  CHECK(plan.value().fourcc == "YUYV");
  CHECK(bench.device.produced == 0);
  CHECK(bench.device.descriptors == 0);
  CHECK(bench.kernel.maps == 0);
  bench.kernel.nodes.clear();
  const auto nothing = bench.camera.check();
  REQUIRE_FALSE(nothing.ok());
  CHECK_THAT(nothing.error(), Contains(kNode) && Contains("No such"));
}

TEST_CASE("A camera that goes away gives back all that it took") {
  FakeKernel kernel;
  FakeCamera device;
  kernel.nodes[kNode] = &device;
  {
    Camera camera({}, kernel, DeviceFolders{});
    CHECK(camera.next(milliseconds(1000), -1).state == kStreaming);
    CHECK(kernel.maps == 4);
  }
  CHECK(kernel.maps == 0);
  CHECK(device.descriptors == 0);
}

TEST_CASE("A camera without a format of ours is decoded, or refused with what it has") {
  CameraBench bench;
  bench.device.formats = {{V4L2_PIX_FMT_YVYU}};
  const CameraEvent first = bench.next();
  if (first.state != kStreaming) {
    CHECK_THAT(bench.reasons[0], Contains("YVYU"));
    return;
  }
  CHECK(bench.camera.plan().decoded);
  CHECK(bench.camera.plan().fourcc == "YVYU");
  CHECK(bench.camera.plan().format == PixelFormat::rgb8);
  for (int k = 0; k < 10; ++k) {
    const Frame frame = bench.frame().frame;
    CHECK(frame.format == PixelFormat::rgb8);
    CHECK(frame.stride_bytes == 3 * 640);
    CHECK(frame.data[3 * 640 * 480 - 1] == frame.data[3 * 640 * 480 - 4]);
  }
  bench.device.broken = true;
  bench.frame();
  CHECK(bench.changes.size() == 3);
}

TEST_CASE("Every state has a name") {
  CHECK(name_of(CameraState::no_signal) == "no_signal");
  CHECK(name_of(kStreaming) == "streaming");
}

}  // namespace
}  // namespace aspect
