#include "runtime/output/output_thread.h"

#include <sched.h>
#include <catch2/catch.hpp>

namespace aspect {
namespace {

cpu_set_t own_processors() {
  cpu_set_t processors;
  CPU_ZERO(&processors);
  REQUIRE(sched_getaffinity(0, sizeof processors, &processors) == 0);
  return processors;
}

std::size_t first_of(const cpu_set_t& processors) {
  std::size_t k = 0;
  while (!CPU_ISSET(k, &processors)) ++k;
  return k;
}

TEST_CASE("a thread is bound to no processor, whatever the frame loop is bound to") {
  const cpu_set_t before = own_processors();
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(first_of(before), &one);
  REQUIRE(sched_setaffinity(0, sizeof one, &one) == 0);
  cpu_set_t seen;
  CPU_ZERO(&seen);
  {
    OutputThread thread;
    const auto error = thread.start("aspect-test", OutputThread::kStackBytes, [&] {
      static_cast<void>(sched_getaffinity(0, sizeof seen, &seen));
    });
    REQUIRE_FALSE(error);
  }
  REQUIRE(sched_setaffinity(0, sizeof before, &before) == 0);
  CHECK(CPU_COUNT(&seen) >= CPU_COUNT(&before));
}

TEST_CASE("a stack that no thread can have is an error, not a larger one") {
  OutputThread thread;
  CHECK(thread.start("aspect-test", 1024, [] {}));
}

}  // namespace
}  // namespace aspect
