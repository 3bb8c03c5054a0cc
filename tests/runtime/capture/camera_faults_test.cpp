#include <catch2/catch.hpp>
#include <cerrno>

#include "tests/runtime/capture/camera_bench.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;
using std::chrono::milliseconds;
using Kind = CameraEvent::Kind;

TEST_CASE("An unplugged camera is absent, with nothing left open, and comes back") {
  CameraBench bench;
  check_recovery(
      bench, CameraState::absent,
      [&] {
        bench.device.unplugged = true;
        bench.kernel.later(milliseconds(10), [&] { bench.kernel.nodes.clear(); });
        bench.kernel.later(milliseconds(100), [&] {
          CHECK(bench.device.descriptors == 0);
          CHECK(bench.kernel.maps == 0);
        });
      },
      [&] {
        bench.device.unplugged = false;
        bench.kernel.nodes[kNode] = &bench.device;
      });
}

TEST_CASE("A disconnected camera works again once nobody holds it") {
  CameraBench bench;
  bench.frame();
  bench.device.disconnected = true;
  bench.frame();
  CHECK(states(bench) == States{kStreaming, CameraState::absent, kStreaming});
}

TEST_CASE("Frames that stop without an error are seen by the watchdog, once") {
  CameraBench bench;
  check_recovery(
      bench, CameraState::stalled, [&] { bench.device.silent = true; },
      [&] { bench.device.silent = false; });
}

TEST_CASE("A camera slower than the watchdog is not disturbed") {
  CameraBench bench;
  bench.device.rate_hz = 0.5;
  bench.frame();
  bench.run(milliseconds(60000));
  CHECK(states(bench) == States{kStreaming});
}

TEST_CASE("A fatal streaming error starts the stream anew at once") {
  CameraBench bench;
  bench.frame();
  const int opens = bench.kernel.opens;
  bench.device.broken = true;
  const auto broken_at = bench.kernel.time;
  const CameraEvent event = bench.next();
  CHECK(event.kind == Kind::changed);
  CHECK(event.state == CameraState::stalled);
  CHECK_THAT(std::string(event.reason), Contains("Input/output"));
  bench.frame();
  CHECK(bench.kernel.time - broken_at < milliseconds(100));
  CHECK(bench.kernel.opens == opens);
  CHECK(states(bench) == States{kStreaming, CameraState::stalled, kStreaming});
}

TEST_CASE("A stream that stays broken is opened anew again and again, and reported once") {
  CameraBench bench;
  check_recovery(
      bench, CameraState::stalled,
      [&] {
        bench.device.broken = true;
        bench.device.errors[VIDIOC_STREAMON].assign(100, EIO);
      },
      [&] { bench.device.errors.clear(); });
  CHECK(bench.kernel.opens < 20);
}

TEST_CASE("A call that fails once at the start is a failure that passes") {
  for (const unsigned long request : {VIDIOC_REQBUFS, VIDIOC_QBUF, VIDIOC_STREAMON, VIDIOC_S_FMT,
                                      VIDIOC_QUERYBUF, VIDIOC_QUERYCAP}) {
    CameraBench bench;
    bench.device.errors[request] = {EINVAL};
    const auto begin = bench.kernel.time;
    bench.frame();
    CHECK(states(bench) == States{CameraState::failed, kStreaming});
    CHECK(bench.kernel.time - begin < milliseconds(500));
  }
}

TEST_CASE("A buffer that cannot be handed back is a failure that passes") {
  CameraBench bench;
  bench.frame();
  bench.device.errors[VIDIOC_QBUF] = {EINVAL};
  bench.frame();
  CHECK(states(bench) == States{kStreaming, CameraState::failed, kStreaming});
}

TEST_CASE("A camera that another process holds is busy until it is let go") {
  CameraBench bench;
  bench.device.taken = true;
  bench.kernel.later(milliseconds(5000), [&] { bench.device.taken = false; });
  bench.frame();
  CHECK(bench.kernel.time - FakeKernel().time < milliseconds(5500));
  CHECK(states(bench) == States{CameraState::busy, kStreaming});
  CHECK_THAT(bench.reasons[0], Contains("another process"));
}

TEST_CASE("A digital input without a signal says so by event, by poll and at the start") {
  for (const int error : {ENOLINK, ENOLCK, ERANGE}) {
    CameraBench bench;
    bench.make_hdmi();
    check_recovery(
        bench, CameraState::no_signal,
        [&] {
          bench.device.query_error = error;
          bench.device.event = error == ENOLINK;
        },
        [&] { bench.device.query_error = 0; });
    CHECK(bench.kernel.opens == 1);
  }
  CameraBench bench;
  bench.make_hdmi();
  bench.device.input_status = V4L2_IN_ST_NO_SIGNAL;
  bench.kernel.later(milliseconds(700), [&] { bench.device.input_status = 0; });
  bench.frame();
  CHECK(states(bench) == States{CameraState::no_signal, kStreaming});
}

TEST_CASE("A digital input that cannot be asked while it streams goes on") {
  CameraBench bench;
  bench.make_hdmi();
  bench.frame();
  bench.device.query_error = EBUSY;
  CHECK(bench.run(milliseconds(3000)) > 80);
  CHECK(states(bench) == States{kStreaming});
}

TEST_CASE("The input's status alone says that the signal is gone") {
  CameraBench bench;
  bench.make_hdmi();
  check_recovery(
      bench, CameraState::no_signal, [&] { bench.device.input_status = V4L2_IN_ST_NO_SYNC; },
      [&] { bench.device.input_status = 0; });
}

TEST_CASE("Timings follow the source, and are left alone where they are right") {
  CameraBench bench;
  bench.make_hdmi();
  bench.device.errors[VIDIOC_S_DV_TIMINGS] = {EIO};
  bench.device.source.pixelclock += 25'000;  // as measured
  bench.frame();
  CHECK(bench.device.errors[VIDIOC_S_DV_TIMINGS].size() == 1);
  bench.device.errors.clear();
  bench.device.source.width = 1280;
  bench.device.source.height = 720;
  bench.device.event = true;
  const auto changed_at = bench.kernel.time;
  bench.frame();
  CHECK(bench.kernel.time - changed_at < milliseconds(100));
  CHECK(bench.device.timings.width == 1280);
  CHECK(states(bench) == States{kStreaming, CameraState::stalled, kStreaming});
  bench.run(milliseconds(5000));
  CHECK(bench.changes.size() == 3);
}

TEST_CASE("Inputs without timings are not polled") {
  CameraBench bench;
  bench.device.has_inputs = true;
  bench.frame();
  const int ioctls = bench.kernel.ioctls;
  const int frames = bench.run(milliseconds(4000));
  CHECK(bench.kernel.ioctls - ioctls <= 3 * frames + 3);
}

TEST_CASE("A camera known by its place comes back under another node") {
  TemporaryFolder folder;
  folder.write("class/video0/name", "");
  folder.write("class/video4/name", "");
  FakeCamera device;
  FakeKernel kernel;
  kernel.nodes["/d/video0"] = &device;
  CameraSettings settings;
  settings.device = "bus:" + device.bus;
  Camera camera(settings, kernel, {(folder.path() / "class").native(), "/d"});
  CHECK(camera.next(milliseconds(1000), -1).state == kStreaming);
  CHECK(camera.plan().node == "/d/video0");
  device.unplugged = true;
  CHECK(camera.next(milliseconds(1000), -1).state == CameraState::absent);
  device.unplugged = false;
  kernel.nodes = {{"/d/video4", &device}};
  const CameraEvent back = camera.next(milliseconds(2000), -1);
  CHECK(back.kind == Kind::changed);
  CHECK(back.state == kStreaming);
  CHECK(camera.plan().node == "/d/video4");
}

}  // namespace
}  // namespace aspect
