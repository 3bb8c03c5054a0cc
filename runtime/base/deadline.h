// Until when there is time. The clock is asked only where there is an end.
#pragma once

#include <chrono>

namespace aspect {

class Deadline {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using Clock = Time (*)();

  // None: it is never over.
  Deadline() = default;
  // The clock must not go back.
  Deadline(Time end, Clock now) : end_(end), now_(now) {}

  bool is_set() const { return now_ != nullptr; }
  bool is_over() const { return now_ != nullptr && now_() >= end_; }

 private:
  Time end_{};
  Clock now_ = nullptr;
};

}  // namespace aspect
