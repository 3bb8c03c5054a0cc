// Lines set and commands started when objects come into view and leave it.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "runtime/output/child_command.h"
#include "runtime/output/gpio_line.h"
#include "runtime/output/output_settings.h"
#include "runtime/output/output_thread.h"
#include "runtime/output/outputs.h"

namespace aspect {

// Whether something is there, believed only after so many frames in a row that say so.
class SteadySight {
 public:
  explicit SteadySight(int frames) : frames_(frames) {}
  // What is believed after this frame.
  bool update(bool present);

 private:
  int frames_, contrary_ = 0;
  bool believed_ = false;
};

// The frame loop compares names and counts; a thread acts. An object that comes and goes while its
// command still runs is reported once that has ended, if it is then otherwise than reported last.
class Triggers {
 public:
  using OpenLine = Result<std::unique_ptr<GpioLine>> (*)(const std::string& chip, int line);

  [[nodiscard]] static std::optional<Error> check(const TriggerOutput& settings);
  [[nodiscard]] static Result<std::unique_ptr<Triggers>> open(
      std::span<const TriggerOutput> settings, OpenLine open_line = open_gpio_line);
  void report_seen(std::span<const SeenName> seen) noexcept;
  OutputThread& thread() { return thread_; }

 private:
  struct Trigger {
    explicit Trigger(const TriggerOutput& asked)
        : settings(asked), sight(asked.frames), command(asked.command, asked.object) {}
    const TriggerOutput settings;
    SteadySight sight;               // the loop's
    std::atomic<bool> seen{false};   // from the loop to the thread
    ChildCommand command;            // from here on the thread's
    std::unique_ptr<GpioLine> line;  // may be null
    bool line_high = false, reported = false, warned = false;
  };

  Triggers() = default;
  void run();
  // True if there is nothing left to be done.
  static bool act(Trigger& trigger);

  std::vector<std::unique_ptr<Trigger>> triggers_;
  OutputThread thread_;  // last: it ends before what it uses
};

}  // namespace aspect
