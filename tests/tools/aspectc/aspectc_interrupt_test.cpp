// aspectc stopped in the middle by a signal that it hears. The next run takes up the work, and its
// index has the bytes of a run that nobody disturbed.
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <csignal>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/temporary_folder.h"
#include "tests/tools/aspectc/run_aspectc.h"
#include "tests/tools/aspectc/terminal_program.h"
#include "tools/aspectc/progress/stop_signals.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Catch::StartsWith;
using Clock = std::chrono::steady_clock;
using nlohmann::json;
using std::chrono::milliseconds;

std::vector<std::string> compile_to(int level) {
  return {ASPECT_SOURCE_DIR "/compiler/models/l_shape.b",
          "--level",
          std::to_string(level),
          "--border-views",
          "0",
          "-o",
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

// Until the terminal shows that.
void watch_for(TerminalProgram& program, const std::string& pattern) {
  const std::regex wanted(pattern);
  const auto end = Clock::now() + std::chrono::seconds(30);
  while (!std::regex_search(program.all_shown(), wanted)) {
    REQUIRE(Clock::now() < end);
    REQUIRE(program.watch_until(Clock::now() + milliseconds(5)));
  }
}

// The program's last words, once it has ended by itself within a second.
std::string interrupt(TerminalProgram& program, int signal) {
  const auto asked = Clock::now();
  program.send(signal);
  CHECK(program.wait() == 1);
  CHECK(Clock::now() - asked < std::chrono::seconds(1));
  const std::vector<std::string> screen = screen_of(program.all_shown());
  REQUIRE(screen.size() == 2);
  CHECK_THAT(screen[0], StartsWith("aspectc: stopped"));
  return screen[0];
}

}  // namespace

TEST_CASE("a run that is interrupted exits with 1 within a second, and the next one resumes it") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const TemporaryFolder folder;
    TerminalProgram first(folder.path(), kCompile, 120);
    watch_for(first, "[1-9][0-9]* of 642 views");
    CHECK_THAT(interrupt(first, signal), Contains("run the same command again"));
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
  TerminalProgram program(folder.path(), with(kCompile, {"--no-store"}), 120);
  watch_for(program, "of 642 views");
  CHECK_THAT(interrupt(program, SIGINT), !Contains("to go on"));
}

TEST_CASE("a second signal ends the program at once") {
  const TemporaryFolder folder;
  TerminalProgram program(folder.path(), kCompile, 120);
  watch_for(program, "of 642 views");
  const auto asked = Clock::now();
  program.send(SIGTERM);
  program.send(SIGINT);
  CHECK(program.wait() == -1);
  CHECK(Clock::now() - asked < milliseconds(300));
}

TEST_CASE("a step that does not listen is ended within a second, with the same words") {
  std::array<int, 2> ends{};
  REQUIRE(pipe(ends.data()) == 0);
  const auto asked = Clock::now();
  const pid_t child = fork();
  if (child == 0) {
    dup2(ends[1], STDERR_FILENO);
    stop_on_signals("stopped, truly");
    kill(getpid(), SIGINT);
    for (;;) pause();
  }
  int status = 0;
  waitpid(child, &status, 0);
  CHECK(Clock::now() - asked < std::chrono::seconds(1));
  CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 1));
  std::array<char, 100> said{};
  REQUIRE(read(ends[0], said.data(), said.size() - 1) > 0);
  CHECK(std::string(said.data()) == "stopped, truly\n");
  for (const int end : ends) close(end);
}

TEST_CASE("an index that is replaced is whole at every moment") {
  const TemporaryFolder folder;
  const fs::path index = folder.path() / "l.aspect";
  REQUIRE(run_aspectc(folder.path(), kCompile).exit_code == 0);
  ChildProgram child(ASPECTC, folder.path(), with(kCompile, {"--max-index-kib", "16"}));
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
