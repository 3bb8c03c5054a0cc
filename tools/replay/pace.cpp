#include "tools/replay/pace.h"

#include <fmt/format.h>
#include <algorithm>
#include <thread>

namespace aspect {
namespace {

using Milliseconds = std::chrono::duration<double, std::milli>;

double in_ms(Pace::Clock::duration duration) {
  return Milliseconds(duration).count();
}

// The least value that such a share of all does not exceed.
Pace::Clock::duration quantile(std::vector<Pace::Clock::duration> values, double share) {
  const auto last = static_cast<double>(values.size() - 1);
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * last + 0.5);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

Pace::Pace(std::optional<double> fps) : fps_(fps) {
  if (fps)
    period_ = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / *fps));
}

void Pace::wait() {
  if (!fps_) return;
  const Clock::time_point now = Clock::now();
  if (next_ == Clock::time_point{}) next_ = now;
  due_ = next_;
  if (now > due_) {
    ++late_;
    largest_lateness_ = std::max(largest_lateness_, now - due_);
  } else {
    std::this_thread::sleep_until(due_);
  }
  next_ = std::max(due_, now - period_) + period_;
}

void Pace::finish() {
  if (fps_) latencies_.push_back(Clock::now() - due_);
}

std::string Pace::report() const {
  if (latencies_.empty()) return {};
  return fmt::format(
      "{} frames at {} a second: {} started late, by {:.2f} ms at most; from due to written "
      "{:.2f} ms median, {:.2f} ms 99th percentile",
      latencies_.size(), *fps_, late_, in_ms(largest_lateness_), in_ms(quantile(latencies_, 0.5)),
      in_ms(quantile(latencies_, 0.99)));
}

}  // namespace aspect
