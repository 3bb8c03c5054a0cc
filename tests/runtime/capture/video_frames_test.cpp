#include <array>
#include <catch2/catch.hpp>
#include <opencv2/videoio.hpp>

#include "runtime/capture/recorded_frames.h"
#include "runtime/capture/stderr_capture.h"
#include "tests/runtime/capture/sample_pictures.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

// Frame k is all of the grey value 40 * (k + 1).
fs::path write_video(const TemporaryFolder& folder, int frames) {
  const fs::path file = folder.path() / "clip.avi";
  cv::VideoWriter writer(file.native(), cv::CAP_OPENCV_MJPEG,
                         cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10, cv::Size(64, 48));
  REQUIRE(writer.isOpened());
  for (int k = 0; k < frames; ++k)
    writer.write(cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(40 * (k + 1))));
  return file;
}

std::string error_of(const fs::path& file, int frames_before) {
  StderrCapture capture;
  RecordedFrames frames(std::array{file});
  CapturedFrame frame;
  FrameStatus status = frames.next(frame);
  for (int k = 0; status == FrameStatus::frame; ++k) status = frames.next(frame);
  const std::string printed = capture.finish();
  REQUIRE(status == FrameStatus::failed);
  CHECK(printed == "");
  if (frames_before >= 0) CHECK(frame.sequence == static_cast<std::uint64_t>(frames_before));
  CHECK_THAT(frame.error, StartsWith(file.native() + ": "));
  CHECK(frames.next(frame) == FrameStatus::end);
  return frame.error;
}

TEST_CASE("A video gives its frames one after the other") {
  const TemporaryFolder folder;
  const fs::path file = write_video(folder, 5);
  const fs::path picture = folder.write("z.png", encoded(noise(4, 4), ".png"));
  RecordedFrames frames(std::array{file, picture});
  CHECK_FALSE(frames.count());
  CapturedFrame frame;
  for (int k = 0; k < 5; ++k) {
    REQUIRE(frames.next(frame) == FrameStatus::frame);
    CHECK(frame.name == file.native() + "#" + std::to_string(k));
    CHECK(frame.sequence == static_cast<std::uint64_t>(k));
    CHECK(frame.width_px == 64);
    CHECK(frame.height_px == 48);
    CHECK(std::abs(int{frame.pixels[1000]} - 40 * (k + 1)) < 6);
  }
  REQUIRE(frames.next(frame) == FrameStatus::frame);
  CHECK(frame.name == picture.native());
  CHECK(frame.sequence == 5);
  CHECK(frames.next(frame) == FrameStatus::end);
}

TEST_CASE("Files that are no videos are refused in one line") {
  const TemporaryFolder folder;
  CHECK_THAT(error_of(folder.write("a.avi", ""), 0), Contains("not a video"));
  CHECK_THAT(error_of(folder.write("a.mp4", "hello, world\n"), 0), Contains("not a video"));
  folder.write("000.ts", encoded(noise(4, 4), ".png"));
  CHECK_THAT(error_of(folder.write("001.mkv", "#EXTM3U\n/etc/passwd\n"), 0),
             Contains("not a video"));
}

TEST_CASE("A video that is cut off gives the frames that it has, then an error") {
  const TemporaryFolder folder;
  const std::string whole = read_file(write_video(folder, 40));
  const fs::path cut = folder.write("cut.avi", whole.substr(0, whole.size() / 2));
  CHECK_THAT(error_of(cut, -1), Contains("cut off"));
}

}  // namespace
}  // namespace aspect
