#include "runtime/output/triggers.h"

#include <algorithm>

#include "runtime/output/descriptor.h"

namespace aspect {
namespace {

constexpr std::chrono::milliseconds kIdle{1000};
constexpr std::chrono::milliseconds kChildRuns{50};  // between looks whether it has ended

}  // namespace

bool SteadySight::update(bool present) {
  contrary_ = present == believed_ ? 0 : contrary_ + 1;
  if (contrary_ >= frames_) {
    believed_ = present;
    contrary_ = 0;
  }
  return believed_;
}

std::optional<Error> Triggers::check(const TriggerOutput& settings) {
  if (settings.command.empty() && settings.gpio_chip.empty())
    return Error{"trigger of " + settings.object + ": does nothing; give command or gpio_chip"};
  if (!settings.gpio_chip.empty())
    if (auto error = check_gpio()) return error;
  return ChildCommand::check(settings.command);
}

Result<std::unique_ptr<Triggers>> Triggers::open(std::span<const TriggerOutput> settings,
                                                 OpenLine open_line) {
  std::unique_ptr<Triggers> triggers(new Triggers());
  for (const TriggerOutput& one : settings) {
    auto trigger = std::make_unique<Trigger>(one);
    if (!one.gpio_chip.empty()) {
      auto line = open_line(one.gpio_chip, one.gpio_line);
      if (!line) return Error{line.error()};
      trigger->line = std::move(line).value();
    }
    triggers->triggers_.push_back(std::move(trigger));
  }
  Triggers* const self = triggers.get();
  if (auto error = self->thread_.start("aspect-triggers", OutputThread::kStackBytes,
                                       [self] { self->run(); }))
    return *error;
  return triggers;
}

void Triggers::report_seen(std::span<const SeenName> seen) noexcept {
  bool changed = false;
  for (const auto& trigger : triggers_) {
    const TriggerOutput& wanted = trigger->settings;
    const bool present = std::any_of(seen.begin(), seen.end(), [&](const SeenName& name) {
      return name.object == wanted.object && name.score >= wanted.score_min;
    });
    const bool believed = trigger->sight.update(present);
    if (trigger->seen.exchange(believed, std::memory_order_relaxed) != believed) changed = true;
  }
  if (changed) thread_.wake();
}

void Triggers::run() {
  while (true) {
    bool done = true;
    for (const auto& trigger : triggers_) done = act(*trigger) && done;
    if (thread_.stopping() && (done || thread_.out_of_time())) return;
    thread_.sleep(done ? kIdle : kChildRuns);
  }
}

bool Triggers::act(Trigger& trigger) {
  const bool seen = trigger.seen.load(std::memory_order_relaxed);
  const TriggerOutput& settings = trigger.settings;
  bool failed = false;
  if (trigger.line && trigger.line_high != seen) {
    failed = !trigger.line->set(seen);
    trigger.line_high = seen;
  }
  if (settings.command.empty()) {
    trigger.reported = seen;
  } else if (!trigger.command.running() && trigger.reported != seen) {
    failed = !trigger.command.start(seen) || failed;
    trigger.reported = seen;
  }
  if (failed && !trigger.warned)
    warn("trigger of " + settings.object + ": failed: " + system_error() +
         "; check its command and its line");
  trigger.warned = trigger.warned || failed;
  return trigger.reported == seen && !trigger.command.running();
}

}  // namespace aspect
