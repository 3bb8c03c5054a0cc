// aspectc stopped in the middle: by Ctrl-C, by kill -9. The next run takes up the work, and its
// index has the bytes of a run that nobody disturbed.
#include <catch2/catch.hpp>
#include <csignal>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "tests/runtime/capture/temporary_folder.h"
#include "tests/tools/aspectc/child_program.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Catch::StartsWith;
using Clock = std::chrono::steady_clock;
using nlohmann::json;
using std::chrono::milliseconds;

std::vector<std::string> compile_to(int level) {
  return {ASPECT_SOURCE_DIR "/compiler/models/l_shape.b", "--level", std::to_string(level), "-o",
          "l.aspect"};
}

// Long enough to be hit in the middle: 642 views at full size.
const std::vector<std::string> kCompile = compile_to(3);

const std::string& undisturbed() {
  static const std::string bytes = [] {
    const TemporaryFolder folder;
    REQUIRE(run_aspectc(folder.path(), kCompile).exit_code == 0);
    return read_file(folder.path() / "l.aspect");
  }();
  return bytes;
}

std::vector<std::string> with(std::vector<std::string> words,
                              const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// The first line of progress tells that a tenth of the views was rendered.
void wait_for_progress(const TemporaryFolder& folder) {
  const auto end = Clock::now() + std::chrono::seconds(10);
  while (!Contains("64 of 642 views").match(read_file(folder.path() / "err"))) {
    REQUIRE(Clock::now() < end);
    std::this_thread::sleep_for(milliseconds(1));
  }
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n') + 1;
  const std::size_t before = text.rfind('\n', end - 1);
  return text.substr(before == std::string::npos ? 0 : before + 1, end);
}

}  // namespace

TEST_CASE("a run that is interrupted exits with 1 within a second, and the next one resumes it") {
  for (const int signal : {SIGINT, SIGTERM}) {
    const TemporaryFolder folder;
    ChildProgram first(folder.path(), with(kCompile, {"--progress", "always"}));
    wait_for_progress(folder);
    const auto asked = Clock::now();
    first.send(signal);
    const Outcome outcome = first.wait();
    CHECK(Clock::now() - asked < std::chrono::seconds(1));
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.out.empty());
    CHECK_THAT(last_line(outcome.err),
               StartsWith("aspectc: ") && Contains("run the same command again"));
    CHECK_FALSE(fs::exists(folder.path() / "l.aspect"));

    CHECK(run_aspectc(folder.path(), with(kCompile, {"--stats", "s.json"})).exit_code == 0);
    CHECK(read_file(folder.path() / "l.aspect") == undisturbed());
    // It did not begin anew: what was rendered before is not rendered again.
    const json stats = json::parse(read_file(folder.path() / "s.json"));
    CHECK(stats["views_rendered"] < stats["views"]);
  }
}

TEST_CASE("without a store an interrupted run does not promise to go on") {
  const TemporaryFolder folder;
  ChildProgram child(folder.path(), with(kCompile, {"--no-store", "--progress", "always"}));
  wait_for_progress(folder);
  child.send(SIGINT);
  const Outcome outcome = child.wait();
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(last_line(outcome.err), Contains("stopped") && !Contains("to go on"));
}

// Work is kept from the second second on, so that this one takes two.
TEST_CASE("five kills at random moments, and the next run gives the undisturbed bytes") {
  const std::vector<std::string> deep = compile_to(4);
  const TemporaryFolder calm, folder;
  REQUIRE(run_aspectc(calm.path(), with(deep, {"--no-store"})).exit_code == 0);
  const std::string undisturbed_bytes = read_file(calm.path() / "l.aspect");
  const fs::path index = folder.path() / "l.aspect";
  std::mt19937 random(5);
  for (int round = 0; round < 5; ++round) {
    const milliseconds moment(round % 2 == 0 ? random() % 500 : 1050 + random() % 150);
    ChildProgram child(folder.path(), deep);
    const auto end = Clock::now() + moment;
    while (Clock::now() < end && !child.has_ended()) std::this_thread::sleep_for(milliseconds(1));
    child.send(SIGKILL);
    child.wait();
    INFO("killed after " << moment.count() << " ms");
    // Never half-written: not there, or whole.
    if (fs::exists(index)) CHECK(read_file(index) == undisturbed_bytes);
  }
  CHECK(run_aspectc(folder.path(), deep).exit_code == 0);
  CHECK(read_file(index) == undisturbed_bytes);
}

TEST_CASE("an index that is replaced is whole at every moment") {
  const TemporaryFolder folder;
  const fs::path index = folder.path() / "l.aspect";
  REQUIRE(run_aspectc(folder.path(), kCompile).exit_code == 0);
  ChildProgram child(folder.path(), with(kCompile, {"--max-index-kib", "16"}));
  std::size_t seen = 0;
  while (!child.has_ended()) {
    const std::string bytes = read_file(index);
    CHECK((bytes == undisturbed() || bytes.size() <= 16 * 1024));
    CHECK(bytes.size() > 8 * 1024);
    ++seen;
  }
  CHECK(child.wait().exit_code == 0);
  CHECK(seen > 1);
  CHECK(fs::file_size(index) <= 16 * 1024);
}

}  // namespace aspect
