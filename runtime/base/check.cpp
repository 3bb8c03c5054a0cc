#include "runtime/base/check.h"

#include <cstdio>
#include <cstdlib>

namespace aspect {

void fail_check(const char* condition, const char* file, int line) noexcept {
  std::fprintf(stderr, "%s:%d: internal check failed: %s; please report this\n", file, line,
               condition);
  std::abort();
}

}  // namespace aspect
