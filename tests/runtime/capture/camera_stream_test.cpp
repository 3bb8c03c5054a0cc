#include "runtime/capture/camera_stream.h"

#include <catch2/catch.hpp>
#include <string>

#include "runtime/capture/camera_negotiation.h"
#include "tests/runtime/capture/fake_kernel.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;
using std::chrono::milliseconds;

struct Bench {
  FakeCamera device;
  FakeKernel kernel;
  CameraSettings settings;
  FoundCamera found;
  StreamFormat format;
  CameraStream stream{kernel};

  Bench(std::uint32_t fourcc, bool multiplanar) {
    device.formats = {{fourcc, {{64, 48}}}};
    if (multiplanar) device.abilities = V4L2_CAP_VIDEO_CAPTURE_MPLANE | V4L2_CAP_STREAMING;
    kernel.nodes["/dev/video0"] = &device;
    settings.width_px = 64;
    settings.height_px = 48;
  }
  ~Bench() { stream.stop(); }

  CameraFault begin() {
    if (CameraFault fault = find_camera(kernel, {}, "/dev/video0", found)) return fault;
    std::vector<std::string> warnings;
    double rate_hz = 0;
    if (CameraFault fault =
            negotiate_format(kernel, found, settings, false, format, rate_hz, warnings))
      return fault;
    if (CameraFault fault = stream.prepare(found.descriptor, format)) return fault;
    return stream.start();
  }
  // What comes of the next frame.
  CameraFault drain(const char*& damage) {
    kernel.advance(kernel.time + milliseconds(34));
    return stream.drain(damage);
  }
  Frame frame() {
    const char* damage = nullptr;
    REQUIRE_FALSE(drain(damage));
    REQUIRE(damage == nullptr);
    REQUIRE(stream.has_frame());
    const StreamFrame taken = stream.take();
    REQUIRE(taken.bytes.data() == taken.frame.data);
    return taken.frame;
  }
};

// Where plane `plane` of that buffer begins, if it is one of the device's.
const std::uint8_t* memory(const Bench& bench, std::size_t buffer, std::size_t plane) {
  return bench.device.buffers.at(buffer).memory.at(plane).data();
}

TEST_CASE("Single-planar frames lie where the driver put them, with its strides") {
  for (const int gap : {0, 32}) {
    Bench bench(V4L2_PIX_FMT_NV12, false);
    bench.device.gap_bytes = static_cast<std::uint32_t>(gap);
    REQUIRE_FALSE(bench.begin());
    CHECK(bench.kernel.maps == 4);
    const Frame frame = bench.frame();
    CHECK(frame.data == memory(bench, 0, 0));
    CHECK(frame.stride_bytes == 64 + gap);
    CHECK(frame.chroma == frame.data + 48 * (64 + gap));
    CHECK(frame.chroma_stride_bytes == 64 + gap);
    CHECK(frame.format == PixelFormat::nv12);
    CHECK(frame.width_px == 64);
    CHECK(frame.height_px == 48);
  }
}

TEST_CASE("Multi-planar frames in one piece and in two, with what stands before them") {
  Bench one(V4L2_PIX_FMT_YUYV, true);
  one.device.data_offset = 16;
  REQUIRE_FALSE(one.begin());
  CHECK(one.frame().data == memory(one, 0, 0) + 16);

  Bench two(V4L2_PIX_FMT_NV21M, true);
  two.device.data_offset = 8;
  REQUIRE_FALSE(two.begin());
  CHECK(two.kernel.maps == 8);
  const Frame frame = two.frame();
  CHECK(frame.format == PixelFormat::nv21);
  CHECK(frame.data == memory(two, 0, 0) + 8);
  CHECK(frame.chroma == memory(two, 0, 1) + 8);
}

TEST_CASE("A frame stays the driver's no longer than it is looked at") {
  Bench bench(V4L2_PIX_FMT_GREY, false);
  bench.settings.sensor = SensorKind::grey;
  REQUIRE_FALSE(bench.begin());
  for (int k = 0; k < 20; ++k) {
    CHECK(bench.frame().data == memory(bench, static_cast<std::size_t>(k) % 4, 0));
    CHECK(bench.device.queued.size() == 3);
    REQUIRE_FALSE(bench.stream.release());
    CHECK(bench.device.queued.size() == 4);
  }
}

TEST_CASE("Time stamps of another clock, of the future or of long ago are not believed") {
  Bench bench(V4L2_PIX_FMT_YUYV, false);
  REQUIRE_FALSE(bench.begin());
  const auto captured = [&] {
    bench.frame();
    // The buffer last taken.
    static_cast<void>(bench.stream.release());
    const char* damage = nullptr;
    CHECK_FALSE(bench.drain(damage));
    return bench.stream.take().captured;
  };
  CHECK(bench.kernel.time - captured() > milliseconds(1));
  static_cast<void>(bench.stream.release());
  const auto set = [&](long seconds) {
    bench.device.spoil_buffer = [=](v4l2_buffer& buffer) { buffer.timestamp.tv_sec = seconds; };
  };
  for (const long seconds : {0L, -5L, 1000L, 0x7FFFFFFFL}) {
    set(seconds);
    CHECK(captured() == bench.kernel.time);
    static_cast<void>(bench.stream.release());
  }
  bench.device.spoil_buffer = nullptr;
  bench.device.stamp_flags = V4L2_BUF_FLAG_TIMESTAMP_UNKNOWN;
  CHECK(captured() == bench.kernel.time);
}

TEST_CASE("A buffer that does not exist, or is not the driver's, is refused") {
  for (const std::uint32_t index : {4U, 31U, 0x80000000U, 0xFFFFFFFFU, 0U}) {
    Bench bench(V4L2_PIX_FMT_YUYV, false);
    REQUIRE_FALSE(bench.begin());
    bench.frame();  // buffer 0
    bench.device.spoil_buffer = [=](v4l2_buffer& buffer) { buffer.index = index; };
    const char* damage = nullptr;
    const CameraFault fault = bench.drain(damage);
    CHECK(fault.state == CameraState::failed);
    CHECK_FALSE(bench.stream.has_frame());
  }
}

TEST_CASE("More bytes than there are, none, or too few are damage") {
  for (const std::uint32_t used : {0U, 1U, 64U * 48 * 2 - 1, 64U * 48 * 2 + 1, 0xFFFFFFFFU}) {
    Bench bench(V4L2_PIX_FMT_YUYV, false);
    REQUIRE_FALSE(bench.begin());
    bench.device.spoil_buffer = [=](v4l2_buffer& buffer) { buffer.bytesused = used; };
    const char* damage = nullptr;
    REQUIRE_FALSE(bench.drain(damage));
    CHECK(damage != nullptr);
    CHECK_FALSE(bench.stream.has_frame());
    CHECK(bench.device.queued.size() == 4);
  }
}

TEST_CASE("Offsets and sizes of a plane that do not fit are damage") {
  struct Case {
    std::uint32_t offset, used;
  };
  for (const Case c : {Case{1, 64 * 48 * 2}, Case{0xFFFFFFFFU, 64 * 48 * 2}, Case{0, 0xFFFFFFFFU},
                       Case{0x80000000U, 0x80000001U}}) {
    Bench bench(V4L2_PIX_FMT_YUYV, true);
    REQUIRE_FALSE(bench.begin());
    bench.device.spoil_buffer = [=](v4l2_buffer& buffer) {
      buffer.m.planes[0].data_offset = c.offset;
      buffer.m.planes[0].bytesused = c.used;
    };
    const char* damage = nullptr;
    REQUIRE_FALSE(bench.drain(damage));
    CHECK(damage != nullptr);
  }
}

TEST_CASE("Buffers that are too small, too few or too many are refused") {
  for (const std::uint32_t length : {0U, 64U * 48 * 2 - 1}) {
    Bench bench(V4L2_PIX_FMT_YUYV, false);
    bench.device.spoil_query = [=](v4l2_buffer& buffer) { buffer.length = length; };
    const CameraFault fault = bench.begin();
    CHECK(fault.state == CameraState::failed);
    CHECK_THAT(std::string(fault.text()), Contains("too small"));
  }
  for (const std::uint32_t count : {1U, 33U, 0xFFFFFFFFU}) {
    Bench bench(V4L2_PIX_FMT_YUYV, false);
    bench.device.granted_buffers = count;
    CHECK(bench.begin().state == CameraState::failed);
    CHECK(bench.kernel.maps == 0);
  }
  Bench more(V4L2_PIX_FMT_YUYV, false);
  more.device.granted_buffers = 6;
  CHECK_FALSE(more.begin());
  CHECK(more.device.queued.size() == 6);
}

TEST_CASE("A buffer that cannot be mapped is a failure, and the others are let go") {
  Bench bench(V4L2_PIX_FMT_YUYV, false);
  bench.device.spoil_query = [](v4l2_buffer& buffer) {
    if (buffer.index == 2) buffer.length = 0x80000000U;
  };
  CHECK(bench.begin().state == CameraState::failed);
  CHECK(bench.kernel.maps == 2);
  bench.stream.stop();
  CHECK(bench.kernel.maps == 0);
}

TEST_CASE("A driver that always has one more frame does not hold us") {
  Bench bench(V4L2_PIX_FMT_YUYV, false);
  REQUIRE_FALSE(bench.begin());
  bench.device.spoil_buffer = [&](v4l2_buffer&) {
    fake_frame(bench.device, bench.kernel.time);
    fake_frame(bench.device, bench.kernel.time);
  };
  const char* damage = nullptr;
  REQUIRE_FALSE(bench.drain(damage));
  CHECK(bench.stream.has_frame());
}

TEST_CASE("A counter that stands still or goes back loses nothing") {
  Bench bench(V4L2_PIX_FMT_YUYV, false);
  REQUIRE_FALSE(bench.begin());
  for (const std::uint32_t sequence : {7U, 7U, 6U, 0U, 0x80000000U}) {
    bench.device.spoil_buffer = [=](v4l2_buffer& buffer) { buffer.sequence = sequence; };
    const char* damage = nullptr;
    REQUIRE_FALSE(bench.drain(damage));
    const StreamFrame taken = bench.stream.take();
    CHECK(taken.lost == 0);
    CHECK(taken.step == 1);
    static_cast<void>(bench.stream.release());
  }
}

}  // namespace
}  // namespace aspect
