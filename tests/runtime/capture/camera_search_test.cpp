#include "runtime/capture/camera_search.h"

#include <catch2/catch.hpp>
#include <cerrno>
#include <filesystem>

#include "runtime/capture/v4l2_text.h"
#include "tests/runtime/capture/fake_kernel.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;

// Two USB cameras with a node for metadata each, and an output, as sysfs shows them.
struct Machine {
  TemporaryFolder folder;
  FakeKernel kernel;
  FakeCamera left, right, metadata, output;
  FoundCamera found;

  Machine() {
    left.bus = "usb-1";
    right.bus = "usb-2";
    metadata.bus = "usb-2";
    metadata.abilities = V4L2_CAP_META_CAPTURE | V4L2_CAP_STREAMING;
    output.abilities = V4L2_CAP_VIDEO_OUTPUT | V4L2_CAP_STREAMING;
    add("video0", output, "");
    add("video2", metadata, "SN2");
    add("video9", left, "SN1");
    add("video10", right, "SN2");
    folder.write("class/v4l-subdev0/name", "");
  }
  void add(const std::string& name, FakeCamera& camera, const std::string& serial) {
    namespace fs = std::filesystem;
    const std::string usb = "devices/usb_" + name;
    if (!serial.empty()) folder.write(usb + "/serial", serial + "\n");
    folder.write(usb + "/interface/video4linux/" + name + "/name", name);
    fs::create_directory_symlink("../..",
                                 folder.path() / usb / "interface/video4linux" / name / "device");
    fs::create_directories(folder.path() / "class");
    fs::create_directory_symlink("../" + usb + "/interface/video4linux/" + name,
                                 folder.path() / "class" / name);
    kernel.nodes["/d/" + name] = &camera;
  }
  CameraFault find(const std::string& device) {
    return find_camera(kernel, {(folder.path() / "class").native(), "/d"}, device, found);
  }
  int descriptors() const {
    return left.descriptors + right.descriptors + metadata.descriptors + output.descriptors;
  }
};

TEST_CASE("Cameras are found by node, place and serial number") {
  Machine machine;
  for (const std::string name : {"/d/video10", "bus:usb-2", "serial:SN2"}) {
    REQUIRE_FALSE(machine.find(name));
    CHECK(machine.found.node == "/d/video10");
    CHECK(machine.found.bus == "usb-2");
    CHECK_FALSE(machine.found.multiplanar());
    CHECK(machine.descriptors() == 1);
    machine.kernel.close(machine.found.descriptor);
  }
  REQUIRE_FALSE(machine.find("serial:SN1"));
  CHECK(machine.found.node == "/d/video9");
}

TEST_CASE("What is not there is absent, and nothing stays open") {
  Machine machine;
  for (const std::string name :
       {"/d/video7", "bus:usb-3", "serial:SN", "serial:SN22", "bus:usb-"}) {
    const CameraFault fault = machine.find(name);
    CHECK(fault.state == CameraState::absent);
    CHECK_FALSE(fault.text().empty());
    CHECK(machine.descriptors() == 0);
  }
  machine.right.unplugged = true;
  CHECK(machine.find("serial:SN2").state == CameraState::absent);
}

TEST_CASE("Nodes that take no pictures are refused by name and passed over otherwise") {
  Machine machine;
  CHECK(machine.find("/d/video2").state == CameraState::failed);
  const CameraFault fault = machine.find("/d/video0");
  CHECK(fault.state == CameraState::failed);
  CHECK_THAT(std::string(fault.text()), Contains("/d/video0"));
  CHECK(machine.descriptors() == 0);
}

TEST_CASE("What stands in the way is said") {
  Machine machine;
  machine.kernel.open_errors["/d/video10"] = EACCES;
  for (const std::string name : {"/d/video10", "bus:usb-2", "serial:SN2"}) {
    const CameraFault fault = machine.find(name);
    CHECK(fault.state == CameraState::failed);
    CHECK_THAT(std::string(fault.text()), Contains("group"));
  }
  machine.kernel.open_errors["/d/video10"] = EBUSY;
  CHECK(machine.find("serial:SN2").state == CameraState::busy);
  machine.left.errors[VIDIOC_QUERYCAP] = {ENOTTY};
  CHECK_THAT(std::string(machine.find("/d/video9").text()), Contains("not a video device"));
}

TEST_CASE("A name that names nothing says what would") {
  Machine machine;
  for (const std::string name : {"", "video0", "bus:", "serial:", "usb:1"})
    CHECK_THAT(std::string(machine.find(name).text()), Contains("serial:NUMBER"));
}

TEST_CASE("A machine without cameras has none") {
  FakeKernel kernel;
  FoundCamera found;
  CHECK(find_camera(kernel, {"/nonexistent", "/d"}, "bus:usb-1", found).state ==
        CameraState::absent);
}

TEST_CASE("Texts of drivers end where their field does and hold nothing strange") {
  Machine machine;
  machine.left.driver = std::string(40, 'x');
  machine.left.card = "\x1B[2Jcamera\n\xFF";
  REQUIRE_FALSE(machine.find("/d/video9"));
  CHECK(machine.found.driver == std::string(16, 'x'));
  CHECK(machine.found.card == "?[2Jcamera??");
}

TEST_CASE("Formats and controls have the names that v4l2-ctl shows") {
  CHECK(fourcc_text(V4L2_PIX_FMT_YUYV) == "YUYV");
  CHECK(fourcc_text(V4L2_PIX_FMT_Z16) == "Z16");
  CHECK(fourcc_of("Z16") == V4L2_PIX_FMT_Z16);
  CHECK(fourcc_of("NV12") == V4L2_PIX_FMT_NV12);
  CHECK(fourcc_of("") == 0);
  CHECK(fourcc_of("MJPEG") == 0);
  CHECK(fourcc_text(0xFFFFFFFFU) == std::string(4, '?') + "-BE");
  CHECK(control_name("White Balance, Automatic") == "white_balance_automatic");
  CHECK(control_name(" Exposure (Absolute)") == "exposure_absolute");
  CHECK(control_name("") == "");
}

}  // namespace
}  // namespace aspect
