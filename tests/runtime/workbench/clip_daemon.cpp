// aspectd with a clip for a camera, to try its page and to measure what the page costs it:
//   clip_daemon FILE.toml NAME.WIDTHxHEIGHT.YUYV
// The camera gives the rate that the configuration asks for, and has controls. At the end (SIGTERM)
// it prints how many frames the camera made, and its lines say which of them were seen.
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>

#include "runtime/capture/raw_frames.h"
#include "runtime/service/daemon.h"
#include "runtime/workbench/workbench_desk.h"
#include "tests/runtime/capture/clip_kernel.h"

namespace aspect {
namespace {

std::vector<FakeControl> controls() {
  return {{.id = V4L2_CID_BRIGHTNESS, .name = "Brightness", .least = -64, .most = 64},
          {.id = V4L2_CID_CONTRAST, .name = "Contrast", .most = 95, .value = 32},
          {.id = V4L2_CID_AUTO_WHITE_BALANCE,
           .name = "White Balance, Automatic",
           .type = V4L2_CTRL_TYPE_BOOLEAN,
           .most = 1,
           .value = 1},
          {.id = V4L2_CID_GAIN, .name = "Gain", .most = 100, .value = 20},
          {.id = V4L2_CID_POWER_LINE_FREQUENCY,
           .name = "Power Line Frequency",
           .type = V4L2_CTRL_TYPE_MENU,
           .most = 2,
           .value = 1,
           .items = {"Disabled", "50 Hz", "60 Hz"}},
          {.id = V4L2_CID_WHITE_BALANCE_TEMPERATURE,
           .name = "White Balance Temperature",
           .least = 2800,
           .most = 6500,
           .value = 4600,
           .automatic = V4L2_CID_AUTO_WHITE_BALANCE,
           .rounding = 10},
          {.id = V4L2_CID_EXPOSURE_ABSOLUTE,
           .name = "Exposure Time, Absolute",
           .least = 1,
           .most = 5000,
           .value = 157}};
}

int run(const char* configuration, const char* clip) {
  const Result<RawFormat> format = raw_format_of(clip);
  if (!format) return std::fprintf(stderr, "clip_daemon: %s\n", format.error().c_str()), 1;
  std::ifstream file(clip, std::ios::binary);
  std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
  FakeCamera camera;
  const auto width = static_cast<std::uint32_t>(format.value().width_px);
  const auto height = static_cast<std::uint32_t>(format.value().height_px);
  camera.formats = {{V4L2_PIX_FMT_YUYV, {{width, height}}}};
  camera.controls = controls();
  ClipKernel kernel(camera, std::move(bytes));
  auto daemon =
      Daemon::start(configuration, {.make_workbench = make_camera_workbench, .calls = &kernel});
  if (!daemon) return std::fprintf(stderr, "clip_daemon: %s\n", daemon.error().c_str()), 1;
  daemon.value()->run();
  std::fprintf(stderr, "clip_daemon: %llu frames\n",
               static_cast<unsigned long long>(camera.produced));
  return 0;
}

}  // namespace
}  // namespace aspect

int main(int argc, char** argv) {
  if (argc != 3) return std::fputs("clip_daemon FILE.toml CLIP\n", stderr), 2;
  try {
    return aspect::run(argv[1], argv[2]);
  } catch (const std::exception& error) {
    return std::fprintf(stderr, "clip_daemon: %s\n", error.what()), 1;
  }
}
