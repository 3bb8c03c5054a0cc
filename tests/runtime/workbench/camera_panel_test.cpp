#include "runtime/workbench/camera_panel.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "runtime/capture/control_words.h"
#include "tests/runtime/capture/fake_kernel.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;

struct Bench {
  FakeCamera device;
  FakeKernel kernel;
  CameraPanel panel{kernel};

  Bench() {
    kernel.nodes["/dev/video0"] = &device;
    device.controls = {
        {.id = V4L2_CID_GAIN, .name = "Gain", .most = 100, .value = 7, .rounding = 5},
        {.id = V4L2_CID_AUTO_WHITE_BALANCE,
         .name = "White Balance, Automatic",
         .type = V4L2_CTRL_TYPE_BOOLEAN,
         .most = 1,
         .value = 1},
        {.id = V4L2_CID_WHITE_BALANCE_TEMPERATURE,
         .name = "White Balance Temperature",
         .least = 2800,
         .most = 6500,
         .value = 4000,
         .automatic = V4L2_CID_AUTO_WHITE_BALANCE},
        {.id = V4L2_CID_POWER_LINE_FREQUENCY,
         .name = "Power Line Frequency",
         .type = V4L2_CTRL_TYPE_MENU,
         .most = 2,
         .items = {"Disabled", "", "60 Hz"}},
        {.id = V4L2_CID_BRIGHTNESS, .name = "Brightness", .flags = V4L2_CTRL_FLAG_READ_ONLY}};
    panel.use("/dev/video0");
  }
  AdjustableControl control(const std::string& name) {
    for (const AdjustableControl& each : panel.controls())
      if (each.name == name) return each;
    FAIL("no " + name);
    return {};
  }
};

}  // namespace

TEST_CASE("a camera's controls are listed with their limits, values and words of menus") {
  Bench bench;
  CHECK(bench.panel.controls().size() == 5);
  const AdjustableControl gain = bench.control("gain");
  CHECK(gain.kind == AdjustableControl::Kind::number);
  CHECK(gain.least == 0);
  CHECK(gain.most == 100);
  CHECK(gain.step == 5);
  CHECK(gain.value == 7);
  CHECK_FALSE(gain.inactive);
  CHECK(bench.control("white_balance_temperature").inactive);
  CHECK(bench.control("white_balance_automatic").kind == AdjustableControl::Kind::truth);
  CHECK(bench.control("brightness").fixed);
  const AdjustableControl mains = bench.control("power_line_frequency");
  CHECK(mains.kind == AdjustableControl::Kind::menu);
  REQUIRE(mains.items.size() == 2);
  CHECK(mains.items[0].name == "Disabled");
  CHECK(mains.items[1].value == 2);
  CHECK(mains.items[1].name == "60 Hz");
  // Nothing stays open.
  CHECK(bench.device.descriptors == 0);
}

TEST_CASE("a control is set at once, and what it governs follows") {
  Bench bench;
  const auto gain = bench.panel.set({"gain", 33});
  REQUIRE(gain.ok());
  CHECK(gain.value().control.value == 30);
  CHECK_FALSE(gain.value().is_automatic);
  CHECK_THAT(gain.value().warnings.at(0), Contains("gain is 30, not 33"));
  const auto automatic = bench.panel.set({"white_balance_automatic", 0});
  REQUIRE(automatic.ok());
  CHECK(automatic.value().is_automatic);
  CHECK(automatic.value().warnings.empty());
  CHECK_FALSE(bench.control("white_balance_temperature").inactive);
  CHECK_FALSE(bench.panel.set({"nonsense", 1}).ok());
  CHECK(bench.device.descriptors == 0);
}

TEST_CASE("without a camera there are no controls, and setting one says so") {
  Bench bench;
  bench.panel.use("");
  CHECK(bench.panel.controls().empty());
  CHECK_THAT(bench.panel.set({"gain", 1}).error(), Contains("cannot be opened"));
  bench.panel.use("/dev/video0");
  bench.device.unplugged = true;
  CHECK(bench.panel.controls().empty());
}

TEST_CASE("there are words for every control that a board's configuration sets") {
  int controls = 0;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(ASPECT_SOURCE_DIR) / "firmware_configs/boards")) {
    std::istringstream lines(read_file(entry.path()));
    bool within = false;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with('[')) within = line == "[camera.controls]";
      const std::size_t name = line.find(" =");
      if (!within || line.starts_with('#') || name == std::string::npos) continue;
      INFO(line);
      ++controls;
      CHECK(find_control_words(line.substr(0, name)) != nullptr);
    }
  }
  CHECK(controls > 6);
}

}  // namespace aspect
