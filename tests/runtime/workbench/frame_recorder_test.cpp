#include "runtime/workbench/frame_recorder.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <thread>

#include "runtime/capture/recorded_frames.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;
constexpr int kWidth_px = 8, kHeight_px = 6;

struct Made {
  PixelFormat format;
  std::vector<std::uint8_t> bytes;

  Made(PixelFormat f, int seed) : format(f), bytes(frame_bytes(f, kWidth_px, kHeight_px)) {
    for (std::size_t k = 0; k < bytes.size(); ++k)
      bytes[k] = static_cast<std::uint8_t>(seed * 31 + static_cast<int>(k) * 7);
  }
  Frame frame() const {
    return {bytes.data(), kWidth_px,
            kHeight_px,   std::ptrdiff_t{bytes_per_pixel(format)} * kWidth_px,
            format,       bytes.data() + kWidth_px * kHeight_px,
            kWidth_px,    {}};
  }
};

// A loop that shows frames 1, 2, ... as long as it exists.
class Loop {
 public:
  Loop(FrameRecorder& recorder, PixelFormat format)
      : thread_([this, &recorder, format] {
          for (int number = 1; !done_; ++number) {
            if (recorder.wanted()) recorder.show(Made(format, number).frame());
            std::this_thread::sleep_for(std::chrono::microseconds(200));
          }
        }) {}
  ~Loop() {
    done_ = true;
    thread_.join();
  }

 private:
  std::atomic<bool> done_{false};
  std::thread thread_;
};

std::vector<std::string> files_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename());
  std::ranges::sort(names);
  return names;
}

Result<Recorded> record(FrameRecorder& recorder, const std::filesystem::path& folder) {
  return recorder.record(folder, std::chrono::seconds(5));
}

}  // namespace

TEST_CASE("ten frames in a row are recorded, and are read again as they were") {
  for (const PixelFormat format : {PixelFormat::yuyv8, PixelFormat::nv12, PixelFormat::bayer_gbrg8,
                                   PixelFormat::rgb8, PixelFormat::bgr8}) {
    INFO(static_cast<int>(format));
    const TemporaryFolder folder;
    FrameRecorder recorder;
    const Loop loop(recorder, format);
    const auto recorded = record(recorder, folder / "new/frames");
    REQUIRE(recorded.ok());
    CHECK(recorded.value().frames == FrameRecorder::kFrames);
    CHECK_FALSE(recorder.wanted());
    const std::vector<std::filesystem::path> paths = {folder / "new/frames"};
    RecordedFrames frames(paths);
    CapturedFrame frame;
    int first = 0;
    for (int k = 0; k < FrameRecorder::kFrames; ++k) {
      REQUIRE(frames.next(frame) == FrameStatus::frame);
      std::vector<std::uint8_t> expected;
      // Pictures are read as BGR.
      const auto is_made = [&](int number) {
        expected = Made(format, number).bytes;
        if (format == PixelFormat::rgb8)
          for (std::size_t at = 0; at < expected.size(); at += 3)
            std::swap(expected[at], expected[at + 2]);
        return frame.pixels == expected;
      };
      if (k == 0)
        while (first < 300 && !is_made(first)) ++first;
      CHECK(is_made(first + k));
    }
    CHECK(frames.next(frame) == FrameStatus::end);
  }
}

TEST_CASE("depths keep their 16 bits") {
  const TemporaryFolder folder;
  FrameRecorder recorder;
  const Loop loop(recorder, PixelFormat::depth16);
  REQUIRE(record(recorder, folder.path()).ok());
  const std::vector<std::filesystem::path> paths = {folder.path()};
  RecordedFrames frames(paths, SensorKind::range);
  CapturedFrame frame;
  REQUIRE(frames.next(frame) == FrameStatus::frame);
  CHECK(frame.format == PixelFormat::depth16);
  int seed = 0;
  while (seed < 300 && Made(PixelFormat::depth16, seed).bytes != frame.pixels) ++seed;
  CHECK(seed < 300);
}

TEST_CASE("nothing that is there is overwritten") {
  const TemporaryFolder folder;
  folder.write("frame_000041.png", "mine");
  folder.write("frame_000007.8x6.YUYV", "mine");
  folder.write("frame_x", "mine");
  FrameRecorder recorder;
  const Loop loop(recorder, PixelFormat::yuyv8);
  for (int k = 0; k < 2; ++k) {
    const auto recorded = record(recorder, folder.path());
    REQUIRE(recorded.ok());
    CHECK(recorded.value().first.filename() ==
          (k == 0 ? "frame_000042.8x6.YUYV" : "frame_000052.8x6.YUYV"));
  }
  CHECK(files_in(folder.path()).size() == 23);
  for (const char* name : {"frame_000041.png", "frame_000007.8x6.YUYV", "frame_x"})
    CHECK(read_file(folder / name) == "mine");
}

TEST_CASE("without frames, a folder or room there is an error and no file") {
  const TemporaryFolder folder;
  FrameRecorder recorder;
  const auto none = recorder.record(folder.path(), std::chrono::milliseconds(50));
  REQUIRE_FALSE(none.ok());
  CHECK_THAT(none.error(), Contains("no frame came"));
  CHECK(files_in(folder.path()).empty());

  const Loop loop(recorder, PixelFormat::yuyv8);
  folder.write("file", "mine");
  CHECK_THAT(record(recorder, folder / "file").error(), Contains("is no folder"));
  CHECK(read_file(folder / "file") == "mine");
  folder.write("full/frame_999995.ppm", "");
  CHECK_THAT(record(recorder, folder / "full").error(), Contains("name another folder"));
}

}  // namespace aspect
