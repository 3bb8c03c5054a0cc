#include "runtime/capture/raw_frames.h"

#include <array>
#include <catch2/catch.hpp>
#include <numeric>

#include "runtime/capture/recorded_frames.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

// Bytes that tell where they come from.
std::string counted(std::size_t bytes) {
  std::string text(bytes, '\0');
  for (std::size_t k = 0; k < bytes; ++k) text[k] = static_cast<char>(k * 7 + k / 251);
  return text;
}

std::string error_of(const fs::path& file, SensorKind sensor = SensorKind::colour) {
  RecordedFrames frames(std::array{file}, sensor);
  CHECK(frames.count() == std::size_t{1});
  CapturedFrame frame;
  REQUIRE(frames.next(frame) == FrameStatus::failed);
  CapturedFrame none;
  CHECK(frames.next(none) == FrameStatus::end);
  CHECK(frame.name == file.native());
  CHECK_THAT(frame.error, StartsWith(file.native() + ": "));
  CHECK(frame.error.find('\n') == std::string::npos);
  return frame.error.substr(file.native().size() + 2);
}

struct Sample {
  std::string fourcc;
  PixelFormat format;
  std::size_t bytes;      // of a frame of 6 x 4
  std::ptrdiff_t stride;  // of its first plane
};

const std::array<Sample, 12> kSamples = {{{"YUYV", PixelFormat::yuyv8, 48, 12},
                                          {"UYVY", PixelFormat::uyvy8, 48, 12},
                                          {"NV12", PixelFormat::nv12, 36, 6},
                                          {"NV21", PixelFormat::nv21, 36, 6},
                                          {"RGB3", PixelFormat::rgb8, 72, 18},
                                          {"BGR3", PixelFormat::bgr8, 72, 18},
                                          {"XB24", PixelFormat::rgbx8, 96, 24},
                                          {"XR24", PixelFormat::bgrx8, 96, 24},
                                          {"RGGB", PixelFormat::bayer_rggb8, 24, 6},
                                          {"GRBG", PixelFormat::bayer_grbg8, 24, 6},
                                          {"GBRG", PixelFormat::bayer_gbrg8, 24, 6},
                                          {"BA81", PixelFormat::bayer_bggr8, 24, 6}}};

TEST_CASE("Raw frames of every format come one after the other with their own bytes") {
  const TemporaryFolder folder;
  for (const Sample& sample : kSamples) {
    INFO(sample.fourcc);
    const std::string bytes = counted(3 * sample.bytes);
    const fs::path file = folder.write("clip.6x4." + sample.fourcc, bytes);
    RecordedFrames frames(std::array{file});
    CHECK(frames.count() == std::size_t{3});
    CapturedFrame frame;
    for (std::size_t k = 0; k < 3; ++k) {
      REQUIRE(frames.next(frame) == FrameStatus::frame);
      CHECK(frame.name == file.native() + "#" + std::to_string(k));
      CHECK(frame.sequence == k);
      const Frame view = frame.view();
      CHECK(view.width_px == 6);
      CHECK(view.height_px == 4);
      CHECK(view.format == sample.format);
      CHECK(view.stride_bytes == sample.stride);
      const std::string got(frame.pixels.begin(), frame.pixels.end());
      CHECK(got == bytes.substr(k * sample.bytes, sample.bytes));
    }
    CHECK(frames.next(frame) == FrameStatus::end);
  }
}

TEST_CASE("The second plane lies behind the first, and YUV is BT.601 of limited range") {
  const TemporaryFolder folder;
  for (const std::string fourcc : {"NV12", "NV21", "YUYV"}) {
    RawFrames frames(folder.write("a.8x6." + fourcc, counted(fourcc == "YUYV" ? 96 : 72)),
                     SensorKind::colour);
    CapturedFrame frame;
    REQUIRE(frames.next(frame) == FrameStatus::frame);
    const Frame view = frame.view();
    CHECK(view.yuv == YuvCoding{YuvMatrix::bt601, false});
    if (fourcc == "YUYV") {
      CHECK(view.chroma == nullptr);
      continue;
    }
    CHECK(view.chroma == view.data + 48);
    CHECK(view.chroma_stride_bytes == 8);
  }
}

TEST_CASE("Frames of a grey camera, and Y of a colour one, are for an index of a grey sensor") {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a.4x4.GREY", counted(16));
  RawFrames frames(file, SensorKind::grey);
  CapturedFrame frame;
  REQUIRE(frames.next(frame) == FrameStatus::frame);
  CHECK(frame.format == PixelFormat::grey8);
  CHECK_THAT(error_of(file), StartsWith("not frames of a colour sensor"));
  CHECK_THAT(error_of(file, SensorKind::range), StartsWith("not frames of a range sensor"));
  CHECK_THAT(error_of(folder.write("a.4x4.RGB3", counted(48)), SensorKind::grey),
             StartsWith("not frames of a grey sensor"));
  RawFrames packed(folder.write("a.4x4.YUYV", counted(32)), SensorKind::grey);
  CHECK(packed.next(frame) == FrameStatus::frame);
}

TEST_CASE("Raw files whose name or size is no good are refused in one line") {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& name, std::size_t bytes) {
    return error_of(folder.write(name, counted(bytes)));
  };
  CHECK_THAT(error("clip.YUYV", 32), StartsWith("the name does not say the size"));
  CHECK_THAT(error("YUYV.640x.YUYV", 32), StartsWith("the name does not say the size"));
  CHECK_THAT(error("a.-4x4.YUYV", 32), StartsWith("-4 x 4 px; nothing can be seen"));
  CHECK_THAT(error("a.99999999999x4.YUYV", 32), StartsWith("the name does not say the size"));
  CHECK_THAT(error("a.4x4.H264", 32), Contains("H264 is no format of raw frames") &&
                                          Contains("YUYV UYVY NV12 NV21 RGB3 BGR3 XB24 XR24 GREY RGGB"));
  CHECK_THAT(error("a.0x0.YUYV", 32), StartsWith("0 x 0 px; nothing can be seen"));
  CHECK_THAT(error("a.8200x4.RGB3", 32), StartsWith("8200 x 4 px; at most 8192"));
  CHECK_THAT(error("a.8000x8000.GREY", 32), StartsWith("8000 x 8000 px; at most 16 megapixels"));
  CHECK_THAT(error("a.5x4.YUYV", 40), StartsWith("YUYV frames have an even width, not 5"));
  CHECK_THAT(error("a.4x5.NV12", 30), StartsWith("NV12 frames have an even height, not 5"));
  CHECK_THAT(error("a.4x5.BA81", 20), StartsWith("BA81 frames have an even height, not 5"));
  CHECK_THAT(error("a.4x4.YUYV", 0), StartsWith("an empty file"));
  CHECK_THAT(error("b.4x4.YUYV", 33), StartsWith("33 bytes are 1 frames of 32 and 1 bytes more"));
  CHECK_THAT(error("c.4x4.YUYV", 31), StartsWith("31 bytes are 0 frames of 32"));
}

TEST_CASE("Packed frames of two pixels may have any height") {
  const TemporaryFolder folder;
  RawFrames frames(folder.write("a.4x5.YUYV", counted(40)), SensorKind::colour);
  CapturedFrame frame;
  CHECK(frames.next(frame) == FrameStatus::frame);
}

TEST_CASE("A file that becomes shorter fails at the frame that is missing") {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a.4x4.YUYV", counted(96));
  RawFrames frames(file, SensorKind::colour);
  CapturedFrame frame;
  REQUIRE(frames.next(frame) == FrameStatus::frame);
  fs::resize_file(file, 70);
  REQUIRE(frames.next(frame) == FrameStatus::frame);
  REQUIRE(frames.next(frame) == FrameStatus::failed);
  CHECK_THAT(frame.error, Contains("became shorter"));
  CHECK(frame.name == file.native() + "#2");
  CHECK(frames.next(frame) == FrameStatus::end);
}

TEST_CASE("A folder gives raw frames among its pictures") {
  const TemporaryFolder folder;
  folder.write("2.4x4.YUYV", counted(64));
  for (const char* name : {"1.ppm", "3.4x4.ppm"})
    folder.write(name, "P6 4 4 255\n" + std::string(48, 'a'));
  folder.write("notes.text", "a");
  RecordedFrames frames(std::array{folder.path()});
  CHECK(frames.count() == std::size_t{4});
  CapturedFrame frame;
  std::uint64_t sequence = 0;
  for (const std::string name : {"1.ppm", "2.4x4.YUYV#0", "2.4x4.YUYV#1", "3.4x4.ppm"}) {
    REQUIRE(frames.next(frame) == FrameStatus::frame);
    CHECK(frame.name == (folder.path() / name).native());
    CHECK(frame.sequence == sequence++);
  }
  CHECK(frames.next(frame) == FrameStatus::end);
}

}  // namespace
}  // namespace aspect
