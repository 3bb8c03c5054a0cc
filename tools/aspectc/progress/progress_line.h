// Progress of a compilation on stderr: one line that is rewritten on a terminal, a plain line now
// and then elsewhere.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include "compiler/aspects/subdivision.h"

namespace aspect {

// automatic: everywhere, but a job that is short is silent: 0.1 s on a terminal, 2 s elsewhere.
// always: elsewhere from the start.
enum class ProgressMode { automatic, always, never };

// "part level 4/5, 320 of 642 views, 83.1 % covered, 12 s left"; views from a store count as done.
// Then its matches; then the clusters.
std::string progress_text(const std::string& object, int last_level, const Progress& progress,
                          std::optional<double> left_s);

// At most that many characters of UTF-8; what is no character on a terminal becomes '?'.
std::string cut_to_width(const std::string& text, std::size_t width);

class ProgressLine {
 public:
  ProgressLine(std::string object, int last_level, ProgressMode mode);
  ~ProgressLine();  // erases the line
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const Progress& progress);

 private:
  using Clock = std::chrono::steady_clock;

  bool is_due(const Progress& progress, Clock::time_point now) const;
  void print(const std::string& text);

  std::string object_;
  int last_level_;
  bool on_;
  bool terminal_;
  std::chrono::milliseconds quiet_;
  bool open_line_ = false;
  Progress shown_;
  int matched_level_ = -1;  // the last one whose matches were begun
  std::optional<Clock::time_point> shown_at_;
  Clock::time_point created_ = Clock::now(), views_at_ = created_, matches_at_ = created_;
};

}  // namespace aspect
