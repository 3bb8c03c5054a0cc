// What aspectc shows while it works: on a terminal, in a narrow one, in a file.
#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <thread>

#include "tests/temporary_folder.h"
#include "tests/tools/aspectc/run_aspectc.h"
#include "tests/tools/aspectc/terminal_program.h"

namespace aspect {
namespace {

using Catch::Contains;
using Catch::StartsWith;
using Clock = TerminalProgram::Clock;
using std::chrono::milliseconds;
using std::chrono::seconds;

const std::string kScene = ASPECT_SOURCE_DIR "/compiler/models/l_shape.b";

std::vector<std::string> compile_to(const std::string& level,
                                    const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {kScene, "--level", level, "--no-store", "-o", "l.aspect"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// Every state of the one line, as it was written.
std::vector<std::string> line_states(const std::string& text) {
  std::vector<std::string> states;
  const std::string erase = "\r\033[K";
  for (std::size_t at = text.find(erase); at != std::string::npos;) {
    const std::size_t next = text.find(erase, at + erase.size());
    states.push_back(text.substr(at + erase.size(), next - at - erase.size()));
    at = next;
  }
  return states;
}

void wait_until_shown(TerminalProgram& program, const std::string& word) {
  const auto end = Clock::now() + seconds(10);
  while (!Contains(word).match(program.all_shown())) {
    REQUIRE(Clock::now() < end);
    REQUIRE(program.watch_until(Clock::now() + milliseconds(10)));
  }
}

void check_has_no_controls(const std::string& text) {
  for (const char c : text) CHECK((c == '\n' || static_cast<unsigned char>(c) >= 0x20));
}

}  // namespace

TEST_CASE("a terminal shows one line that is rewritten, and at the end only what was made") {
  const TemporaryFolder folder;
  TerminalProgram program(folder.path(), compile_to("4"), 120);
  REQUIRE(program.wait() == 0);
  const std::vector<std::string> screen = screen_of(program.all_shown());
  REQUIRE(screen.size() == 2);
  CHECK_THAT(screen[0], StartsWith("l.aspect: ") && Contains("classes cover"));
  CHECK(screen[1].empty());

  const std::vector<std::string> states = line_states(program.all_shown());
  REQUIRE(states.size() > 4);
  for (std::size_t i = 0; i + 1 < states.size(); ++i) {
    CHECK_THAT(states[i], (StartsWith("l_shape level ") || StartsWith("l_shape borders ")) &&
                              Contains(" views, ") && Contains(" % covered") && !Contains("\n"));
  }
  CHECK_THAT(program.all_shown(), Contains("level 3/4") && Contains("level 4/4") &&
                                      Contains(" s left") && Contains(" clusters, "));
}

TEST_CASE("a narrow terminal gets a line that fits") {
  const TemporaryFolder folder;
  TerminalProgram narrow(folder.path(), compile_to("3"), 24);
  REQUIRE(narrow.wait() == 0);
  const std::vector<std::string> states = line_states(narrow.all_shown());
  REQUIRE(states.size() > 2);
  for (std::size_t i = 0; i + 1 < states.size(); ++i) CHECK(states[i].size() == 23);
}

TEST_CASE("a job of a moment shows nothing on a terminal") {
  const TemporaryFolder folder;
  folder.write("dot.b",
               "studio { at 0 0 0 up 0 0 1 angle 50 resolution 32 32 antialias none ambient 1 1 1 }"
               "surface { diffuse .8 .1 .1 } sphere { center 0 0 0 radius .2 }");
  TerminalProgram program(folder.path(),
                          {"dot.b", "--level", "1", "--min-level", "1", "--no-store"});
  CHECK(program.wait() == 0);
  CHECK_THAT(program.all_shown(), StartsWith("dot.aspect: ") && !Contains("\033"));
}

TEST_CASE("Ctrl-C leaves one line, within a second") {
  const TemporaryFolder folder;
  TerminalProgram program(folder.path(), compile_to("6"), 100);
  wait_until_shown(program, " of 642 views");
  const auto asked = Clock::now();
  program.type("\x03");
  CHECK(program.wait() == 1);
  CHECK(Clock::now() - asked < seconds(1));
  const std::vector<std::string> screen = screen_of(program.all_shown());
  REQUIRE(screen.size() == 2);
  CHECK_THAT(screen[0], StartsWith("aspectc: stopped before the index was complete"));
}

TEST_CASE("a terminal that cannot erase a line, and a file, get plain lines") {
  const TemporaryFolder folder;
  TerminalProgram dumb(folder.path(), compile_to("3", {"--progress", "always"}), 120, "dumb");
  REQUIRE(dumb.wait() == 0);
  CHECK_THAT(dumb.all_shown(), Contains("level 3/3") && !Contains("\033"));

  const Outcome file = run_aspectc(folder.path(), compile_to("4", {"--progress", "always"}));
  REQUIRE(file.exit_code == 0);
  check_has_no_controls(file.err);
  for (const char* word : {"level 3/4", "level 4/4", " clusters, "})
    CHECK_THAT(file.err, Contains(word));
  // One a level, one for the clusters, and one every two seconds.
  CHECK(std::count(file.err.begin(), file.err.end(), '\n') <= 30);
}

TEST_CASE("a file gets lines unasked once a job takes more than two seconds") {
  const TemporaryFolder folder;
  ChildProgram child(ASPECTC, folder.path(), compile_to("7"));
  const auto started = Clock::now();
  while (read_file(folder.path() / "err").empty() && Clock::now() - started < seconds(10)) {
    REQUIRE_FALSE(child.has_ended());
    std::this_thread::sleep_for(milliseconds(5));
  }
  CHECK(Clock::now() - started >= milliseconds(1900));
  child.send(SIGINT);
  const Outcome outcome = child.wait();
  CHECK_THAT(outcome.err, (StartsWith("l_shape level ") || StartsWith("l_shape borders ")) &&
                              Contains("\naspectc: stopped"));
  check_has_no_controls(outcome.err);
}

TEST_CASE("never is silent on a terminal too") {
  const TemporaryFolder folder;
  TerminalProgram program(folder.path(), compile_to("3", {"--progress", "never"}));
  CHECK(program.wait() == 0);
  CHECK_THAT(program.all_shown(), StartsWith("l.aspect: ") && !Contains("\033"));
}

}  // namespace aspect
