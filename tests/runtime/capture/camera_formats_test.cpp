#include "runtime/capture/camera_formats.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "runtime/capture/camera_decoder.h"
#include "runtime/capture/camera_negotiation.h"
#include "runtime/capture/camera_stream.h"
#include "runtime/capture/v4l2_text.h"
#include "tests/runtime/capture/fake_kernel.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;

struct Agreement {
  CameraFault fault;
  StreamFormat stream;
  double rate_hz = 0;
  std::vector<std::string> warnings;

  std::string fourcc() const { return fourcc_text(stream.format.fourcc); }
};

Agreement negotiate(FakeCamera& device, const CameraSettings& settings, bool decoder = false) {
  FakeKernel kernel;
  kernel.nodes["/dev/video0"] = &device;
  FoundCamera found;
  Agreement result;
  REQUIRE_FALSE(find_camera(kernel, {}, "/dev/video0", found));
  result.fault = negotiate_format(kernel, found, settings, decoder, result.stream, result.rate_hz,
                                  result.warnings);
  return result;
}

TEST_CASE("The cheapest format for the sensor is taken, however they are listed") {
  FakeCamera device;
  device.formats = {{V4L2_PIX_FMT_MJPEG}, {V4L2_PIX_FMT_SRGGB8}, {V4L2_PIX_FMT_GREY},
                    {V4L2_PIX_FMT_RGB24}, {V4L2_PIX_FMT_NV12},   {V4L2_PIX_FMT_UYVY},
                    {V4L2_PIX_FMT_Z16}};
  CameraSettings settings;
  CHECK(negotiate(device, settings, true).fourcc() == "UYVY");
  settings.sensor = SensorKind::grey;
  CHECK(negotiate(device, settings, true).fourcc() == "GREY");
  std::erase_if(device.formats,
                [](const FakeFormat& format) { return format.fourcc == V4L2_PIX_FMT_GREY; });
  CHECK(negotiate(device, settings, true).fourcc() == "UYVY");
  settings.sensor = SensorKind::range;
  CHECK(negotiate(device, settings, true).stream.format.pixels == PixelFormat::depth16);
  settings.sensor = SensorKind::surface;
  const Agreement none = negotiate(device, settings, true);
  CHECK(none.fault.state == CameraState::failed);
  CHECK_THAT(std::string(none.fault.text()), Contains("surface") && Contains("MJPG RGGB RGB3"));
}

TEST_CASE("Each of our formats is what its name says") {
  const std::pair<std::uint32_t, PixelFormat> rows[] = {
      {V4L2_PIX_FMT_YUYV, PixelFormat::yuyv8},
      {V4L2_PIX_FMT_UYVY, PixelFormat::uyvy8},
      {V4L2_PIX_FMT_NV12, PixelFormat::nv12},
      {V4L2_PIX_FMT_NV21, PixelFormat::nv21},
      {V4L2_PIX_FMT_RGB24, PixelFormat::rgb8},
      {V4L2_PIX_FMT_BGR24, PixelFormat::bgr8},
      {V4L2_PIX_FMT_SRGGB8, PixelFormat::bayer_rggb8},
      {V4L2_PIX_FMT_SGRBG8, PixelFormat::bayer_grbg8},
      {V4L2_PIX_FMT_SGBRG8, PixelFormat::bayer_gbrg8},
      {V4L2_PIX_FMT_SBGGR8, PixelFormat::bayer_bggr8}};
  for (const auto& [fourcc, pixels] : rows) {
    FakeCamera device;
    device.formats = {{fourcc}};
    const Agreement agreed = negotiate(device, {});
    REQUIRE_FALSE(agreed.fault);
    CHECK(agreed.stream.format.pixels == pixels);
    CHECK_FALSE(agreed.stream.format.decoded);
    CHECK(agreed.warnings.empty());
  }
}

TEST_CASE("A format asked for by name is taken, and one that is missing is warned of") {
  FakeCamera device;
  device.formats = {{V4L2_PIX_FMT_YUYV}, {V4L2_PIX_FMT_RGB24}};
  CameraSettings settings;
  settings.format = "RGB3";
  CHECK(negotiate(device, settings).fourcc() == "RGB3");
  settings.format = "NV12";
  const Agreement agreed = negotiate(device, settings);
  CHECK(agreed.fourcc() == "YUYV");
  REQUIRE(agreed.warnings.size() == 1);
  CHECK_THAT(agreed.warnings[0], Contains("NV12"));
}

TEST_CASE("The nearest size goes before the cheapest format, and so does a sufficient rate") {
  FakeCamera device;
  device.formats = {{V4L2_PIX_FMT_YUYV, {{320, 240}, {640, 360}}, {}, 30},
                    {V4L2_PIX_FMT_NV12, {{320, 240}, {640, 480}}, {}, 5},
                    {V4L2_PIX_FMT_RGB24, {{640, 480}}, {}, 60}};
  CameraSettings settings;
  CHECK(negotiate(device, settings).fourcc() == "NV12");
  settings.rate_hz = 60;
  CHECK(negotiate(device, settings).fourcc() == "RGB3");
  settings.width_px = 600;
  settings.height_px = 350;
  const Agreement agreed = negotiate(device, settings);
  CHECK(agreed.fourcc() == "YUYV");
  CHECK(agreed.stream.height_px == 360);
  REQUIRE_FALSE(agreed.warnings.empty());
  CHECK_THAT(agreed.warnings.back(), Contains("640 x 360") && Contains("600 x 350"));
}

TEST_CASE("Sizes by steps are met as nearly as the steps allow") {
  for (std::uint32_t least = 0; least < 8; ++least)
    for (std::uint32_t most = 0; most < 40; most += 3)
      for (std::uint32_t step = 0; step < 7; ++step)
        for (int wanted = -3; wanted < 50; ++wanted) {
          const auto nearest = nearest_step(least, most, step, wanted);
          REQUIRE(nearest.has_value() == (least <= most));
          if (!nearest) continue;
          int best = 1000;
          for (std::uint32_t size = least; size <= most; size += std::max(step, 1U))
            best = std::min(best, std::abs(static_cast<int>(size) - wanted));
          REQUIRE(*nearest >= least);
          REQUIRE(*nearest <= most);
          REQUIRE((*nearest - least) % std::max(step, 1U) == 0);
          REQUIRE(std::abs(static_cast<int>(*nearest) - wanted) == best);
        }
  CHECK(nearest_step(0, 0xFFFFFFFFU, 0xFFFFFFFFU, 5) == 0U);
  CHECK(nearest_step(0x80000000U, 0xFFFFFFFFU, 1, 640) == 0x80000000U);
  FakeCamera device;
  device.formats[0].range = v4l2_frmsize_stepwise{32, 1920, 16, 32, 1080, 8};
  CameraSettings settings;
  settings.width_px = 650;
  CHECK(negotiate(device, settings).stream.width_px == 656);
}

TEST_CASE("A driver that silently takes another format or size is found out") {
  FakeCamera device;
  device.formats = {{V4L2_PIX_FMT_YUYV}, {V4L2_PIX_FMT_UYVY}};
  device.spoil_format = [](v4l2_format& format) {
    format.fmt.pix.pixelformat = V4L2_PIX_FMT_BGR24;
    format.fmt.pix.width = 320;
    format.fmt.pix.bytesperline = 960;
  };
  const Agreement agreed = negotiate(device, {});
  REQUIRE_FALSE(agreed.fault);
  CHECK(agreed.stream.format.pixels == PixelFormat::bgr8);
  CHECK(agreed.stream.width_px == 320);
  REQUIRE(agreed.warnings.size() == 1);
  CHECK_THAT(agreed.warnings[0], Contains("320 x 480"));
  device.lies = true;
  CHECK(negotiate(device, {}).stream.width_px == 320);
  device.lies = false;
  device.spoil_format = [](v4l2_format& format) {
    format.fmt.pix.pixelformat = V4L2_PIX_FMT_MJPEG;
  };
  CHECK_THAT(std::string(negotiate(device, {}).fault.text()), Contains("MJPG"));
}

TEST_CASE("Sizes and strides that cannot be are refused") {
  const std::function<void(v4l2_pix_format&)> spoils[] = {
      [](v4l2_pix_format& p) { p.width = 0; },
      [](v4l2_pix_format& p) { p.height = 0; },
      [](v4l2_pix_format& p) { p.width = 0x80000000U; },
      [](v4l2_pix_format& p) { p.width = p.height = 0x10000; },
      [](v4l2_pix_format& p) { p.width = p.height = 8192; },
      [](v4l2_pix_format& p) { p.bytesperline = 1279; },
      [](v4l2_pix_format& p) { p.bytesperline = 0x80000000U; },
      [](v4l2_pix_format& p) { p.field = V4L2_FIELD_ALTERNATE; }};
  for (const auto& spoil : spoils) {
    FakeCamera device;
    device.spoil_format = [&](v4l2_format& format) { spoil(format.fmt.pix); };
    CHECK(negotiate(device, {}).fault.state == CameraState::failed);
  }
  FakeCamera device;
  device.spoil_format = [](v4l2_format& format) { format.fmt.pix.bytesperline = 0; };
  CHECK(negotiate(device, {}).stream.stride_bytes[0] == 1280);
  for (const int planes : {0, 2, 255}) {
    FakeCamera multi;
    multi.abilities = V4L2_CAP_VIDEO_CAPTURE_MPLANE | V4L2_CAP_STREAMING;
    multi.spoil_format = [&](v4l2_format& format) {
      format.fmt.pix_mp.num_planes = static_cast<std::uint8_t>(planes);
    };
    CHECK(negotiate(multi, {}).fault.state == CameraState::failed);
  }
}

TEST_CASE("Odd rows and columns of formats that go by pairs are cut off") {
  FakeCamera device;
  device.formats = {{V4L2_PIX_FMT_NV12, {{641, 481}}}};
  const Agreement agreed = negotiate(device, {});
  CHECK(agreed.stream.width_px == 640);
  CHECK(agreed.stream.height_px == 480);
  // The second plane still begins behind all rows of the first.
  CHECK(frame_bytes(agreed.stream, 0) == 641 * 481 + 239 * 641 + 640);
}

TEST_CASE("Rates are set and what became of them is read back") {
  FakeCamera device;
  CameraSettings settings;
  CHECK(negotiate(device, settings).rate_hz == 30);
  settings.rate_hz = 15;
  CHECK(negotiate(device, settings).rate_hz == 15);
  CHECK(device.rate_hz == 15);
  device.rate_fixed = true;
  settings.rate_hz = 25;
  const Agreement agreed = negotiate(device, settings);
  CHECK(agreed.rate_hz == 15);
  REQUIRE(agreed.warnings.size() == 1);
  CHECK_THAT(agreed.warnings[0], Contains("15") && Contains("25"));
}

TEST_CASE("Colour coding follows V4L2's rules for what a driver leaves open") {
  const YuvCoding narrow601{YuvMatrix::bt601, false}, wide601{YuvMatrix::bt601, true};
  CHECK(yuv_coding(V4L2_COLORSPACE_SRGB, 0, 0) == narrow601);
  CHECK(yuv_coding(V4L2_COLORSPACE_SMPTE170M, 0, 0) == narrow601);
  CHECK(yuv_coding(V4L2_COLORSPACE_JPEG, 0, 0) == wide601);
  CHECK(yuv_coding(V4L2_COLORSPACE_REC709, 0, 0) == YuvCoding{YuvMatrix::bt709, false});
  CHECK(yuv_coding(V4L2_COLORSPACE_BT2020, 0, V4L2_QUANTIZATION_FULL_RANGE) ==
        YuvCoding{YuvMatrix::bt2020, true});
  CHECK(yuv_coding(V4L2_COLORSPACE_REC709, V4L2_YCBCR_ENC_601, 0) == narrow601);
  CHECK(yuv_coding(V4L2_COLORSPACE_JPEG, 0, V4L2_QUANTIZATION_LIM_RANGE) == narrow601);
  CHECK(yuv_coding(0xFFFFFFFFU, 0xFFFFFFFFU, 0xFFFFFFFFU) == narrow601);
}

TEST_CASE("An endless list of formats ends") {
  FakeCamera device;
  device.formats.assign(100000, FakeFormat{V4L2_PIX_FMT_YUYV});
  CHECK_FALSE(negotiate(device, {}).fault);
}

// A decoder for a camera that has nothing but this format, at 64 x 48.
struct DecoderBench {
  explicit DecoderBench(std::uint32_t fourcc) {
    device.formats = {{fourcc, {{64, 48}}}};
    CameraSettings settings;
    settings.width_px = 64;
    settings.height_px = 48;
    const Agreement agreed = negotiate(device, settings, true);
    REQUIRE_FALSE(agreed.fault);
    REQUIRE(agreed.stream.format.decoded);
    kernel.nodes["/dev/video0"] = &device;
    REQUIRE(decoder.open(kernel, kernel.open("/dev/video0"), agreed.stream));
  }
  FakeCamera device;
  FakeKernel kernel;
  CameraDecoder decoder;
};

TEST_CASE("A format that is not ours comes out of the decoder as RGB") {
  if (!CameraDecoder::available()) return;
  DecoderBench bench(V4L2_PIX_FMT_YVYU);
  // Y 128, V 128 and U 128 are grey; more V is red.
  std::vector<std::uint8_t> picture(64 * 48 * 2, 128);
  for (std::size_t k = 1; k < picture.size() / 2; k += 4) picture[k] = 200;
  Frame frame;
  REQUIRE(bench.decoder.decode(picture, frame));
  CHECK(frame.format == PixelFormat::rgb8);
  CHECK(frame.stride_bytes == 192);
  CHECK(int{frame.data[0]} > frame.data[2] + 50);
  CHECK(int{frame.data[0]} > frame.data[1] + 50);
  const std::uint8_t* below = frame.data + 40 * frame.stride_bytes;
  CHECK(below[0] == below[1]);
  CHECK(below[1] == below[2]);
  CHECK_FALSE(bench.decoder.decode(std::span(picture).first(100), frame));
}

TEST_CASE("MJPEG is decoded, and damaged or cut off pictures do no harm") {
  if (!CameraDecoder::available()) return;
  DecoderBench bench(V4L2_PIX_FMT_MJPEG);
  std::ifstream file(ASPECT_SOURCE_DIR "/tests/data/camera/halves.jpg", std::ios::binary);
  const std::vector<char> text(std::istreambuf_iterator<char>(file), {});
  REQUIRE(text.size() > 500);
  const std::vector<std::uint8_t> picture(text.begin(), text.end());
  Frame frame;
  REQUIRE(bench.decoder.decode(picture, frame));
  const auto is_near = [&](int x, std::array<int, 3> rgb) {
    const std::uint8_t* pixel = frame.data + 24 * frame.stride_bytes + 3 * x;
    return std::abs(pixel[0] - rgb[0]) + std::abs(pixel[1] - rgb[1]) + std::abs(pixel[2] - rgb[2]) <
           15;
  };
  CHECK(is_near(8, {220, 30, 30}));
  CHECK(is_near(56, {30, 60, 220}));

  CHECK_FALSE(bench.decoder.decode({}, frame));
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    std::vector<std::uint8_t> damaged = picture;
    for (int change = 0; change < 4; ++change)
      damaged[random() % damaged.size()] = static_cast<std::uint8_t>(random());
    if (round % 3 == 0) damaged.resize(random() % damaged.size());
    static_cast<void>(bench.decoder.decode(damaged, frame));
  }
  REQUIRE(bench.decoder.decode(picture, frame));
  CHECK(is_near(8, {220, 30, 30}));
}

}  // namespace
}  // namespace aspect
