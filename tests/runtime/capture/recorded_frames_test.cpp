#include "runtime/capture/recorded_frames.h"

#include <sys/stat.h>
#include <array>
#include <catch2/catch.hpp>

#include "runtime/capture/stderr_capture.h"
#include "tests/runtime/capture/sample_pictures.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

CapturedFrame read_one(const fs::path& path) {
  RecordedFrames frames(std::array{path});
  CapturedFrame frame;
  const FrameStatus status = frames.next(frame);
  INFO(frame.error);
  REQUIRE(status == FrameStatus::frame);
  CapturedFrame none;
  REQUIRE(frames.next(none) == FrameStatus::end);
  return frame;
}

// The error of a path that is no good, of one line, with nothing printed by any library.
std::string error_of(const fs::path& path) {
  StderrCapture capture;
  RecordedFrames frames(std::array{path});
  CapturedFrame frame;
  const FrameStatus status = frames.next(frame);
  const std::string printed = capture.finish();
  REQUIRE(status == FrameStatus::failed);
  CHECK(printed == "");
  CHECK(frame.error.find('\n') == std::string::npos);
  CHECK_THAT(frame.error, StartsWith(path.native() + ": "));
  return frame.error.substr(path.native().size() + 2);
}

std::array<int, 3> pixel(const CapturedFrame& frame) {
  return {frame.pixels[0], frame.pixels[1], frame.pixels[2]};
}

TEST_CASE("A picture becomes a frame with its own pixels") {
  const TemporaryFolder folder;
  const cv::Mat picture = noise(33, 17);
  const fs::path file = folder.write("a.png", encoded(picture, ".png"));
  const CapturedFrame frame = read_one(file);
  CHECK(frame.name == file.native());
  CHECK(frame.sequence == 0);
  CHECK(frame.width_px == 33);
  CHECK(frame.height_px == 17);
  CHECK(frame.view().stride_bytes == 99);
  CHECK(frame.view().format == PixelFormat::bgr8);
  REQUIRE(frame.pixels.size() == std::size_t{33} * 17 * 3);
  CHECK(std::equal(frame.pixels.begin(), frame.pixels.end(), picture.data));
}

TEST_CASE("Pictures of every kind become colours of 8 bits") {
  const TemporaryFolder folder;
  const auto first_pixel = [&](const cv::Mat& picture, const std::string& ending) {
    return pixel(read_one(folder.write("a" + ending, encoded(picture, ending))));
  };
  const cv::Scalar colour(10, 20, 30, 0);
  CHECK(first_pixel(cv::Mat(4, 4, CV_8UC3, colour), ".png") == std::array{10, 20, 30});
  CHECK(first_pixel(cv::Mat(4, 4, CV_8UC4, colour + cv::Scalar(0, 0, 0, 255)), ".png") ==
        std::array{10, 20, 30});
  CHECK(first_pixel(cv::Mat(4, 4, CV_8UC1, cv::Scalar(77)), ".png") == std::array{77, 77, 77});
  CHECK(first_pixel(cv::Mat(4, 4, CV_16UC3, colour * 257), ".png") == std::array{10, 20, 30});
  CHECK(first_pixel(cv::Mat(4, 4, CV_8UC1, cv::Scalar(77)), ".jpg") == std::array{77, 77, 77});
  CHECK(first_pixel(cv::Mat(4, 4, CV_8UC3, colour), ".bmp") == std::array{10, 20, 30});
  CHECK(first_pixel(cv::Mat(4, 4, CV_8UC3, colour), ".ppm") == std::array{10, 20, 30});
  CHECK(first_pixel(cv::Mat(4, 4, CV_8UC3, colour), ".tiff") == std::array{10, 20, 30});
}

TEST_CASE("Range and surface frames are read as they are, and as nothing else") {
  const TemporaryFolder folder;
  cv::Mat depths(5, 7, CV_16UC1);
  for (int i = 0; i < 35; ++i)
    depths.at<std::uint16_t>(i / 7, i % 7) = static_cast<ushort>(1801 * i);
  const fs::path file = folder.write("d.png", encoded(depths, ".png"));
  for (const SensorKind sensor : {SensorKind::range, SensorKind::surface}) {
    RecordedFrames frames(std::array{file}, sensor);
    CapturedFrame frame;
    REQUIRE(frames.next(frame) == FrameStatus::frame);
    CHECK(gives(sensor, frame.view().format));
    CHECK(frame.view().stride_bytes == 14);
    REQUIRE(frame.pixels.size() == 70);
    CHECK(std::equal(frame.pixels.begin(), frame.pixels.end(), depths.data));
  }
  CHECK_THAT(error_of(file), Contains("a range or surface frame and not a colour one"));
  for (const cv::Mat& other : {cv::Mat(4, 4, CV_8UC1, cv::Scalar(7)), noise(4, 4),
                               cv::Mat(4, 4, CV_16UC3, cv::Scalar(7, 8, 9))}) {
    RecordedFrames frames(std::array{folder.write("o.png", encoded(other, ".png"))},
                          SensorKind::range);
    CapturedFrame frame;
    REQUIRE(frames.next(frame) == FrameStatus::failed);
    CHECK_THAT(frame.error, Contains("not a range frame"));
  }
}

TEST_CASE("A grey sensor's frames are greys of whatever was recorded, but for videos") {
  const TemporaryFolder folder;
  const cv::Mat colours(4, 4, CV_8UC3, cv::Scalar(10, 100, 200));
  const std::array<fs::path, 2> files = {folder.write("c.png", encoded(colours, ".png")),
                                         folder.write("v.avi", encoded(colours, ".png"))};
  RecordedFrames frames(files, SensorKind::grey);
  CapturedFrame frame;
  REQUIRE(frames.next(frame) == FrameStatus::frame);
  CHECK(frame.view().format == PixelFormat::grey8);
  REQUIRE(frame.pixels.size() == 16);
  CHECK(std::abs(frame.pixels[0] - 120) <= 1);
  REQUIRE(frames.next(frame) == FrameStatus::failed);
  CHECK_THAT(frame.error, Contains("a video"));
}

TEST_CASE("The contents count, not the ending") {
  const TemporaryFolder folder;
  CHECK(read_one(folder.write("a.dat", encoded(noise(5, 4), ".jpg"))).width_px == 5);
}

TEST_CASE("Files that are no pictures are refused in one line") {
  const TemporaryFolder folder;
  CHECK_THAT(error_of(folder.path() / "none.png"), StartsWith("no such file"));
  CHECK_THAT(error_of(folder.write("empty.png", "")), StartsWith("an empty file"));
  CHECK_THAT(error_of(folder.write("text.png", "hello, world\n")), StartsWith("not a picture"));
  CHECK_THAT(error_of(folder.write("one.png", "\x89")), StartsWith("not a picture"));
  const fs::path pipe = folder.path() / "pipe.png";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_THAT(error_of(pipe), StartsWith("neither a file nor a folder"));
}

TEST_CASE("Pictures that are cut off are refused in one line") {
  const TemporaryFolder folder;
  for (const std::string ending : {".png", ".jpg"}) {
    const std::string whole = encoded(noise(64, 64), ending);
    for (const std::size_t parts : {2U, 3U, 10U})
      CHECK_THAT(error_of(folder.write("cut" + ending, whole.substr(0, whole.size() / parts))),
                 StartsWith("cut off"));
  }
}

TEST_CASE("Pictures with damage inside are refused in one line") {
  const TemporaryFolder folder;
  const std::string jpeg = encoded(noise(64, 64), ".jpg");
  const std::string end = "\xFF\xD9";
  CHECK_THAT(error_of(folder.write("a.jpg", jpeg.substr(0, jpeg.size() / 2) + end)),
             StartsWith("damaged (Corrupt JPEG data"));
  std::string png = encoded(noise(64, 64), ".png");
  png[png.size() / 2] = static_cast<char>(png[png.size() / 2] ^ 0x55);
  CHECK_THAT(error_of(folder.write("a.png", png)), StartsWith("damaged ("));
}

TEST_CASE("Pictures too large are refused whatever their format") {
  const TemporaryFolder folder;
  const cv::Mat wide(4, 8200, CV_8UC3, cv::Scalar(1, 2, 3));
  for (const std::string ending : {".png", ".jpg", ".bmp", ".ppm", ".tiff"})
    CHECK_THAT(error_of(folder.write("wide" + ending, encoded(wide, ending))),
               StartsWith("8200 x 4 px; at most 8192 px a side"));
}

TEST_CASE("A folder gives its pictures in the order of their names") {
  const TemporaryFolder folder;
  for (const std::string name : {"10.png", "2.PNG", "a.jpg", "02.bmp"})
    folder.write(name, encoded(noise(4, 4), fs::path(name).extension()));
  folder.write("truth.csv", "a,b\n");
  folder.write("deeper/0.png", encoded(noise(4, 4), ".png"));
  RecordedFrames frames(std::array{folder.path()});
  CHECK(frames.count() == std::size_t{4});
  CapturedFrame frame;
  std::uint64_t sequence = 0;
  for (const std::string name : {"02.bmp", "10.png", "2.PNG", "a.jpg"}) {
    REQUIRE(frames.next(frame) == FrameStatus::frame);
    CHECK(frame.name == (folder.path() / name).native());
    CHECK(frame.sequence == sequence++);
  }
  CHECK(frames.next(frame) == FrameStatus::end);
}

TEST_CASE("A folder without pictures says so, and where they may be") {
  const TemporaryFolder folder;
  folder.write("truth.csv", "a,b\n");
  CHECK_THAT(error_of(folder.path()), StartsWith("holds no pictures (.png"));
  folder.write("frames/0.png", encoded(noise(4, 4), ".png"));
  CHECK_THAT(error_of(folder.path()), Contains("give " + (folder.path() / "frames").native()));
}

TEST_CASE("A bad frame does not end the batch") {
  const TemporaryFolder folder;
  folder.write("0.png", encoded(noise(4, 4), ".png"));
  folder.write("1.png", "");
  folder.write("2.png", encoded(noise(6, 5), ".png"));
  const std::array paths = {folder.path(), folder.path() / "none", folder.path() / "0.png"};
  RecordedFrames frames(paths);
  CapturedFrame frame;
  const std::array expected = {FrameStatus::frame,  FrameStatus::failed, FrameStatus::frame,
                               FrameStatus::failed, FrameStatus::frame,  FrameStatus::end};
  for (std::size_t k = 0; k < expected.size(); ++k) {
    REQUIRE(frames.next(frame) == expected[k]);
    if (expected[k] == FrameStatus::frame) CHECK(frame.error == "");
    if (expected[k] != FrameStatus::end) CHECK(frame.sequence == k);
  }
}

TEST_CASE("Without paths there are no frames") {
  RecordedFrames frames({});
  CapturedFrame frame;
  CHECK(frames.next(frame) == FrameStatus::end);
  CHECK(frames.next(frame) == FrameStatus::end);
}

}  // namespace
}  // namespace aspect
