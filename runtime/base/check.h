// Checks of our own logic. A failed check is a bug in Aspect, never bad input: it prints the
// condition and the place, then aborts.
#pragma once

namespace aspect {

[[noreturn]] void fail_check(const char* condition, const char* file, int line) noexcept;

}  // namespace aspect

// Always on: for load time.
#define ASPECT_CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::aspect::fail_check(#condition, __FILE__, __LINE__))

// Debug and test builds only: for the per-frame path.
#ifdef NDEBUG
#define ASPECT_DCHECK(condition) static_cast<void>(0)
#else
#define ASPECT_DCHECK(condition) ASPECT_CHECK(condition)
#endif
