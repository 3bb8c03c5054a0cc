// Colours on a pseudo-terminal, which script(1) gives, and nowhere else.
#include <catch2/catch.hpp>
#include <string>

#include "tests/child_program.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;

constexpr const char* kEscape = "\x1b[";

class Desk {
 public:
  Desk() {
    folder_.write("truth.csv",
                  "file,object,vx,vy,vz,x,y,w,h,visible\n"
                  "0.png,cube,1,0,0,10,10,100,100,1\n1.png,ball,1,0,0,10,10,100,100,1\n");
    std::string seen;
    for (const char* frame : {"0.png", "1.png"})
      seen += std::string(R"({"frame":")") + frame +
              R"(","sequence":0,"elapsed_ms":1,"objects":[{"box":[10,10,100,100],)"
              R"("hypotheses":[{"object":"cube","view":[1,0,0]}]}]})"
              "\n";
    folder_.write("seen.ndjson", seen);
    // One triangle, which is open.
    folder_.write("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n");
  }
  std::string on_terminal(const std::string& variables, const std::string& command) const {
    return run_shell(folder_.path(), "env -u NO_COLOR " + variables + " script -qec '" +
                                         ASPECT_PROGRAMS "/" + command + "' /dev/null </dev/null")
        .out;
  }
  Outcome in_pipe(const std::string& command) const {
    return run_shell(folder_.path(), "env -u NO_COLOR TERM=xterm " ASPECT_PROGRAMS "/" + command);
  }

 private:
  TemporaryFolder folder_;
};

constexpr const char* kScore = "aspect-score truth.csv seen.ndjson --table";

TEST_CASE("A table on a terminal shows right in green and wrong in red, aligned as without") {
  const Desk desk;
  const std::string shown = desk.on_terminal("TERM=xterm", kScore);
  CHECK_THAT(shown, Contains("cube  \x1b[1;32mcube\x1b[0m        0.00"));
  CHECK_THAT(shown, Contains("ball  \x1b[1;31mcube\x1b[0m           -"));
  CHECK_THAT(desk.in_pipe(kScore).out, Contains("cube  cube        0.00"));
}

TEST_CASE("Complaints and findings have their words in colour on a terminal") {
  const Desk desk;
  CHECK_THAT(desk.on_terminal("TERM=xterm", "aspectc none.b"),
             Contains("\x1b[1;31maspectc:\x1b[0m none.b: "));
  CHECK_THAT(desk.on_terminal("TERM=xterm", "aspectc doctor open.off"),
             Contains("\x1b[1;33mwarning\x1b[0m ") || Contains("\x1b[1;31merror\x1b[0m "));
}

TEST_CASE("No colours in pipes, on dumb terminals, or where NO_COLOR says anything") {
  const Desk desk;
  for (const char* command : {kScore, "aspectc none.b", "aspectc doctor open.off"}) {
    INFO(command);
    const Outcome piped = desk.in_pipe(command);
    CHECK_THAT(piped.out + piped.err, !Contains(kEscape));
    for (const char* variables : {"TERM=dumb", "TERM=xterm NO_COLOR=1", "TERM=xterm NO_COLOR=0"})
      CHECK_THAT(desk.on_terminal(variables, command), !Contains(kEscape));
    CHECK_THAT(desk.on_terminal("TERM=xterm NO_COLOR=", command), Contains(kEscape));
  }
}

}  // namespace
}  // namespace aspect
