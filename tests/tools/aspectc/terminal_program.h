// aspectc on a terminal of a test's own: what it shows, and when.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace aspect {

// Starts aspectc in that folder with its three streams on a pseudo-terminal.
class TerminalProgram {
 public:
  using Clock = std::chrono::steady_clock;
  struct Shown {
    Clock::time_point at;
    std::string text;
  };

  TerminalProgram(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                  int columns = 80, const std::string& kind = "xterm");
  ~TerminalProgram();
  TerminalProgram(const TerminalProgram&) = delete;
  TerminalProgram& operator=(const TerminalProgram&) = delete;

  // Reads until then, or until the program has ended. False: it has.
  bool watch_until(Clock::time_point end);
  void send(int signal) const;
  void type(const std::string& keys) const;  // "\x03" is Ctrl-C
  int wait();                                // exit code; -1: ended by a signal

  const std::vector<Shown>& shown() const { return shown_; }
  std::string all_shown() const;

 private:
  int terminal_ = -1;
  pid_t id_ = -1;
  bool reaped_ = false;
  std::vector<Shown> shown_;
};

// What is left on the screen of a terminal that knows \r, \n, "erase to the end of the line" and
// colours: one string a line, without colours. Any other escape is kept as it is.
std::vector<std::string> screen_of(const std::string& text);

}  // namespace aspect
