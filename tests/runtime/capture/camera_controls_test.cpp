#include "runtime/capture/camera_controls.h"

#include <catch2/catch.hpp>
#include <cerrno>

#include "tests/runtime/capture/fake_kernel.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;
using Texts = std::vector<std::string>;

struct Bench {
  FakeCamera device;
  FakeKernel kernel;
  Texts values, warnings;

  Bench() {
    kernel.nodes["/dev/video0"] = &device;
    device.controls = {
        {.id = V4L2_CID_USER_CLASS, .name = "User Controls", .type = V4L2_CTRL_TYPE_CTRL_CLASS},
        {.id = V4L2_CID_GAIN, .name = "Gain"},
        {.id = V4L2_CID_AUTO_WHITE_BALANCE,
         .name = "White Balance, Automatic",
         .type = V4L2_CTRL_TYPE_BOOLEAN,
         .most = 1,
         .value = 1},
        {.id = V4L2_CID_POWER_LINE_FREQUENCY,
         .name = "Power Line Frequency",
         .type = V4L2_CTRL_TYPE_MENU,
         .most = 2},
        {.id = V4L2_CID_WHITE_BALANCE_TEMPERATURE,
         .name = "White Balance Temperature",
         .least = 2800,
         .most = 6500,
         .value = 4000,
         .automatic = V4L2_CID_AUTO_WHITE_BALANCE},
        {.id = V4L2_CID_EXPOSURE_ABSOLUTE,
         .name = "Exposure Time, Absolute",
         .most = 5000,
         .rounding = 50},
        {.id = V4L2_CID_PIXEL_RATE,
         .name = "Pixel Rate",
         .type = V4L2_CTRL_TYPE_INTEGER64,
         .most = std::int64_t{1} << 40U}};
  }
  CameraFault set(const std::vector<CameraControl>& controls) {
    values.clear();
    warnings.clear();
    return set_controls(kernel, kernel.open("/dev/video0"), controls, values, warnings);
  }
  // The only warning.
  std::string warning_of(const std::vector<CameraControl>& controls) {
    REQUIRE_FALSE(set(controls));
    REQUIRE(warnings.size() == 1);
    return warnings[0];
  }
  FakeControl& control(std::uint32_t id) {
    return *std::ranges::find(device.controls, id, &FakeControl::id);
  }
};

TEST_CASE("Controls are set by name and read back") {
  Bench bench;
  REQUIRE_FALSE(bench.set({{"gain", 17},
                           {"power_line_frequency", 1},
                           {"exposure_time_absolute", 100},
                           {"pixel_rate", std::int64_t{1} << 35U}}));
  CHECK(bench.warnings.empty());
  CHECK(bench.values == Texts{"gain = 17", "power_line_frequency = 1",
                              "exposure_time_absolute = 100", "pixel_rate = 34359738368"});
  CHECK(bench.control(V4L2_CID_GAIN).value == 17);
}

TEST_CASE("A manual value takes once its automatic is off") {
  Bench bench;
  REQUIRE_FALSE(bench.set({{"white_balance_automatic", 0}, {"white_balance_temperature", 5000}}));
  CHECK(bench.warnings.empty());
  bench.control(V4L2_CID_AUTO_WHITE_BALANCE).value = 1;
  CHECK_THAT(bench.warning_of({{"white_balance_temperature", 5000}}), Contains("no effect"));
}

TEST_CASE("What a later setting changes is read back as it ends up") {
  Bench bench;
  CHECK_THAT(bench.warning_of({{"gain", 3}, {"gain", 5}}), Contains("gain is 5, not 3"));
}

TEST_CASE("Controls that are missing, refused, read-only, held or rounded are warned of") {
  Bench bench;
  CHECK_THAT(bench.warning_of({{"gian", 1}}), Contains("gian") && Contains("mean gain"));
  CHECK_THAT(bench.warning_of({{"exposure_time_absolute", 120}}), Contains("is 100, not 120"));
  CHECK_THAT(bench.warning_of({{"gain", 300}}), Contains("from 0 to 255"));
  CHECK(bench.control(V4L2_CID_GAIN).value == 255);
  CHECK_THAT(bench.warning_of({{"gain", -1}}), Contains("-1"));
  CHECK(bench.values == Texts{"gain = 0"});
  bench.control(V4L2_CID_GAIN).refusal = ERANGE;
  CHECK_THAT(bench.warning_of({{"gain", 9}}), Contains("refuses gain = 9"));
  CHECK(bench.values == Texts{"gain = 0"});
  bench.control(V4L2_CID_GAIN).flags = V4L2_CTRL_FLAG_READ_ONLY;
  CHECK_THAT(bench.warning_of({{"gain", 9}}), Contains("only be read"));
  CHECK(bench.values == Texts{"gain = 0"});
  bench.control(V4L2_CID_GAIN).flags = V4L2_CTRL_FLAG_GRABBED;
  CHECK_THAT(bench.warning_of({{"gain", 9}}), Contains("another program"));
  bench.control(V4L2_CID_GAIN).flags = V4L2_CTRL_FLAG_DISABLED;
  CHECK_THAT(bench.warning_of({{"gain", 9}}), Contains("no control gain"));
  CHECK_THAT(bench.warning_of({{"user_controls", 9}}), Contains("no control"));
  bench.control(V4L2_CID_PIXEL_RATE).type = V4L2_CTRL_TYPE_STRING;
  CHECK_THAT(bench.warning_of({{"pixel_rate", 9}}), Contains("not a number"));
}

TEST_CASE("Controls are locked where the driver can, and left alone where none are asked for") {
  Bench bench;
  REQUIRE_FALSE(bench.set({}));
  CHECK(bench.device.priority == V4L2_PRIORITY_DEFAULT);
  REQUIRE_FALSE(bench.set({{"gain", 17}}));
  CHECK(bench.device.priority == V4L2_PRIORITY_RECORD);
  bench.device.has_priorities = false;
  CHECK_THAT(bench.warning_of({{"gain", 18}}), Contains("no lock"));
  CHECK(bench.values == Texts{"gain = 18"});
}

TEST_CASE("A camera that goes away meanwhile is absent") {
  Bench bench;
  bench.device.errors[VIDIOC_S_CTRL] = {ENODEV};
  CHECK(bench.set({{"gain", 1}}).state == CameraState::absent);
}

TEST_CASE("Names without an end, limits the wrong way round and masks do no harm") {
  Bench bench;
  FakeControl& gain = bench.control(V4L2_CID_GAIN);
  gain.name = std::string(32, 'g');
  gain.least = 10;
  gain.most = -10;
  REQUIRE_FALSE(bench.set({{std::string(32, 'g'), 4}}));
  CHECK(bench.values == Texts{std::string(32, 'g') + " = 4"});
  gain.name = "mask";
  gain.type = V4L2_CTRL_TYPE_BITMASK;
  gain.most = static_cast<std::int32_t>(0xFFFFFFFFU);
  REQUIRE_FALSE(bench.set({{"mask", 0xF0000001}}));
  CHECK(bench.values.size() == 1);
  CHECK(bench.warnings.empty());
  CHECK_THAT(bench.warning_of({{"mask", 0x1F0000001}}), Contains("from 0 to 4294967295"));
}

}  // namespace
}  // namespace aspect
