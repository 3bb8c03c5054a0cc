// Frames that start at a steady rate, and how well it was kept.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace aspect {

// Times are counted from when a frame was due, as from the moment that a camera takes it. One that
// comes late by more than a period moves all that follow.
class Pace {
 public:
  using Clock = std::chrono::steady_clock;

  // Without a rate: as fast as possible, and nothing to report.
  explicit Pace(std::optional<double> fps);

  // Before a frame: waits until it is due. After it: its line is out.
  void wait();
  void finish();

  // One line: how many frames started late, and the latencies. Empty without a rate or frames.
  std::string report() const;

 private:
  std::optional<double> fps_;
  Clock::duration period_{};
  Clock::time_point next_{}, due_{};
  std::size_t late_ = 0;
  Clock::duration largest_lateness_{};
  std::vector<Clock::duration> latencies_;
};

}  // namespace aspect
