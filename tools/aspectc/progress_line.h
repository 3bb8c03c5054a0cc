// Progress of a compilation on stderr: one line that is rewritten on a terminal, a plain line now
// and then elsewhere.
#pragma once

#include <chrono>
#include <string>

#include "compiler/aspects/subdivision.h"

namespace aspect {

enum class ProgressMode { automatic, always, never };

class ProgressLine {
 public:
  ProgressLine(std::string object, int last_level, ProgressMode mode);
  ~ProgressLine();  // leaves the terminal on a fresh line

  void show(const Progress& progress);

 private:
  std::string text(const Progress& progress) const;

  using Clock = std::chrono::steady_clock;
  std::string object_;
  int last_level_;
  bool on_;
  bool terminal_;
  bool open_line_ = false;
  int shown_level_ = -1;
  Clock::time_point start_ = Clock::now(), shown_{}, level_start_ = Clock::now();
};

}  // namespace aspect
