// aspectd as its users start it, on a machine without the camera that it asks for. What it does
// with a camera is tested in booted kernels.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <sstream>
#include <thread>

#include "tests/child_program.h"
#include "tests/temporary_folder.h"
#include "tests/tools/json_lines.h"
#include "tests/tools/tiny_index.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using nlohmann::json;

constexpr const char* kConfiguration =
    "indexes = [\"flag.aspect\"]\n"
    "[camera]\ndevice = \"/dev/no-such-camera\"\n"
    "[output]\nstdout = true\n";

class Station {
 public:
  Station() {
    cv::Mat flag(120, 160, CV_8UC3, cv::Scalar(0, 0, 0));
    flag(cv::Rect(40, 30, 40, 60)).setTo(cv::Scalar(30, 30, 230));
    flag(cv::Rect(80, 30, 40, 60)).setTo(cv::Scalar(30, 230, 30));
    write_tiny_index(folder_.path() / "flag.aspect", "flag", flag);
    configure(kConfiguration);
  }
  void configure(const std::string& text) const { folder_.write("aspectd.toml", text); }
  Outcome run(const std::vector<std::string>& arguments) const {
    return ChildProgram(ASPECTD, folder_.path(), arguments).wait();
  }
  Outcome check() const { return run({"--config", "aspectd.toml", "--check"}); }
  const TemporaryFolder& folder() const { return folder_; }

  // Runs aspectd until its output has so many lines, calls act(child), and so on; then ends it.
  template <typename... Acts>
  Outcome live(Acts&&... acts) const {
    ChildProgram child(ASPECTD, folder_.path(), {"--config", "aspectd.toml"});
    std::size_t lines = 1;
    (..., (wait_for_lines(child, lines++), acts(child)));
    wait_for_lines(child, lines);
    child.send(SIGTERM);
    return child.wait();
  }

 private:
  void wait_for_lines(ChildProgram& child, std::size_t count) const {
    for (int tries = 0; tries < 1000 && !child.has_ended(); ++tries) {
      const std::string text = read_file(folder_.path() / "out");
      if (static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) >= count) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    INFO(read_file(folder_.path() / "err"));
    REQUIRE_FALSE("aspectd said less than expected");
  }

  TemporaryFolder folder_;
};

TEST_CASE("Help and version are printed, and wrong usage is exit code 2") {
  const Station station;
  CHECK_THAT(station.run({"--help"}).out, Contains("--config FILE.toml"));
  CHECK_THAT(station.run({"--version"}).out, StartsWith("aspectd "));
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{},
                                                {"--check"},
                                                {"--nonsense"},
                                                {"--config"},
                                                {"--config", "a", "b"}})
    CHECK(station.run(wrong).exit_code == 2);
}

TEST_CASE("A configuration that is no good is refused with one line") {
  const Station station;
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "aspectd: aspectd.toml: names no indexes"},
      {"indexes = [\"none.aspect\"]\n", "aspectd: none.aspect: cannot be read"},
      {"indexes = [\"flag.aspect\"]\n[camera]\ndevise = \"/dev/video0\"\n",
       "aspectd: aspectd.toml:3: [camera] devise is not known here; did you mean device?"},
      {"indexes = [\"flag.aspect\"]\n[output.tcp]\nport = 70000\n", "aspectd: aspectd.toml:3: "},
      {"indexes = [\"flag.aspect\", \"flag.aspect\"]\n", "aspectd: flag.aspect: given twice"},
  };
  for (const auto& [text, expected] : cases) {
    station.configure(text);
    for (const Outcome& outcome : {station.check(), station.run({"--config", "aspectd.toml"})}) {
      CHECK(outcome.exit_code == 1);
      CHECK_THAT(outcome.err, StartsWith(expected));
      CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    }
  }
}

TEST_CASE("A damaged index keeps aspectd from starting") {
  const Station station;
  std::string bytes = read_file(station.folder().path() / "flag.aspect");
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
  station.folder().write("flag.aspect", bytes);
  const Outcome outcome = station.run({"--config", "aspectd.toml"});
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, StartsWith("aspectd: flag.aspect: "));
}

TEST_CASE("A check prints what will be used, and fails without the camera") {
  const Outcome outcome = Station().check();
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, StartsWith("aspectd: camera /dev/no-such-camera: "));
  CHECK_THAT(outcome.out, Contains("index: flag, 1 classes") && Contains("frames of 640 x 480") &&
                              Contains("output: standard output"));
}

TEST_CASE("A check as JSON says what the words say") {
  const Station station;
  station.configure(std::string(kConfiguration) +
                    "[output.file]\npath = \"seen \\\"1\\\".ndjson\"\nkeep = 2\n"
                    "[[output.trigger]]\nobject = \"flag\"\nscore_min = 2.5\n"
                    "command = [\"/bin/true\"]\n");
  const Outcome words = station.check();
  const Outcome outcome = station.run({"--config", "aspectd.toml", "--check", "--json"});
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.err == words.err);
  const json report = json::parse(outcome.out);
  CHECK(report["right"] == false);
  CHECK(report["camera"].is_null());
  CHECK(report["indexes"].size() == 1);
  CHECK(report["indexes"][0]["object"] == "flag");
  CHECK(report["indexes"][0]["classes"] == 1);
  CHECK(report["memory"]["width"] == 640);
  CHECK(report["memory"]["bytes"].get<double>() > 640 * 480);
  CHECK(report["outputs"][0] == json{{"kind", "stdout"}});
  CHECK(report["outputs"][1]["kind"] == "file");
  CHECK_THAT(report["outputs"][1]["path"].get<std::string>(), Contains("seen \"1\".ndjson"));
  CHECK(report["outputs"][1]["keep"] == 2);
  CHECK(report["triggers"] == json{{{"object", "flag"}, {"score_min", 2.5}}});
  CHECK("aspectd: " + report["errors"][0].get<std::string>() + "\n" == outcome.err);
  CHECK(station.run({"--config", "aspectd.toml", "--json"}).exit_code == 2);
}

TEST_CASE("The configurations of boards are right but for the camera") {
  const Station station;
  std::filesystem::rename(station.folder().path() / "flag.aspect",
                          station.folder().path() / "part.aspect");
  int boards = 0;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(ASPECT_SOURCE_DIR) / "firmware_configs/boards")) {
    INFO(entry.path());
    ++boards;
    station.configure(read_file(entry.path()));
    const Outcome outcome = station.check();
    CHECK_THAT(outcome.out, Contains("index: flag, 1 classes") && Contains("output: "));
    // On a machine with a camera, that one may refuse a control.
    std::istringstream complaints(outcome.err);
    for (std::string line; std::getline(complaints, line);)
      CHECK_THAT(line,
                 StartsWith("aspectd: camera /dev/video0: ") || StartsWith("aspectd: warning: "));
  }
  CHECK(boards == 6);
}

TEST_CASE("Without its camera aspectd says so, waits, and ends when it is told to") {
  const Outcome outcome = Station().live();
  CHECK(outcome.exit_code == 0);
  const auto lines = json_lines(outcome.out);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0]["state"] == "absent");
  CHECK(lines[0]["camera"] == "/dev/no-such-camera");
  CHECK(lines[0]["reason"].get<std::string>().size() > 5);
  CHECK_THAT(outcome.err, Contains("aspectd: ready\n") && Contains("aspectd: stopped\n"));
}

TEST_CASE("A reload takes a good configuration and refuses a bad one") {
  const Station station;
  const Outcome outcome = station.live(
      [&](const ChildProgram& child) {
        station.configure("indexes = [\"gone.aspect\"]\n");
        child.send(SIGHUP);
      },
      [&](const ChildProgram& child) {
        station.configure(std::string(kConfiguration) + "[recognition]\ntop = 3\n");
        child.send(SIGHUP);
      });
  CHECK(outcome.exit_code == 0);
  const auto lines = json_lines(outcome.out);
  REQUIRE(lines.size() == 3);
  CHECK(lines[1]["state"] == "reload_failed");
  CHECK_THAT(lines[1]["reason"].get<std::string>(), StartsWith("gone.aspect: cannot be read"));
  CHECK(lines[2]["state"] == "reloaded");
}

TEST_CASE("A reload with another camera looks for that one") {
  const Station station;
  const Outcome outcome = station.live([&](const ChildProgram& child) {
    station.configure(
        "indexes = [\"flag.aspect\"]\n[camera]\ndevice = \"serial:none\"\n[output]\nstdout = "
        "true\n");
    child.send(SIGHUP);
  });
  const auto lines = json_lines(outcome.out);
  REQUIRE(lines.size() >= 2);
  CHECK(lines[1]["camera"] == "serial:none");
}

}  // namespace
}  // namespace aspect
