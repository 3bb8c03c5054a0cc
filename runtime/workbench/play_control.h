// Recorded frames go on by themselves, stand still, or go on one by one.
#pragma once

#include <atomic>

namespace aspect {

struct PlayControl {
  std::atomic<bool> paused{false};
  std::atomic<int> steps{0};  // still to be gone while paused
};

}  // namespace aspect
