#include "tests/runtime/base/allocation_counter.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace aspect {
namespace {

// Keeps compilers from leaving out an allocation that nobody looks at.
template <typename T>
T* seen(T* block) {
  asm volatile("" : "+r"(block) : : "memory");
  return block;
}

template <typename Action>
std::uint64_t allocations_of(Action&& action) {
  const std::uint64_t before = allocation_count();
  action();
  return allocation_count() - before;
}

}  // namespace

TEST_CASE("work on the stack alone counts nothing") {
  REQUIRE(allocations_of([] {
            int local[64] = {};
            seen(local);
          }) == 0);
}

TEST_CASE("every way of asking the heap is counted") {
  CHECK(allocations_of([] { std::free(seen(std::malloc(40))); }) == 1);
  CHECK(allocations_of([] { std::free(seen(std::calloc(4, 40))); }) == 1);
  CHECK(allocations_of([] { std::free(seen(std::aligned_alloc(64, 640))); }) == 1);
  CHECK(allocations_of([] { std::free(seen(std::realloc(seen(std::malloc(40)), 4000))); }) == 2);
  CHECK(allocations_of([] {
          void* block = nullptr;
          if (posix_memalign(&block, 64, 640) == 0) std::free(seen(block));
        }) == 1);
}

TEST_CASE("new, containers, strings and libc's own allocations are counted") {
  struct alignas(128) Wide {
    char bytes[128];
  };
  CHECK(allocations_of([] { seen(std::make_unique<int>().get()); }) == 1);
  CHECK(allocations_of([] { seen(std::make_unique<Wide>().get()); }) == 1);
  CHECK(allocations_of([] { seen(std::vector<int>(100).data()); }) == 1);
  CHECK(allocations_of([] { seen(std::string(100, 'a').data()); }) == 1);
  CHECK(allocations_of([] { std::free(seen(strdup("a line of text"))); }) == 1);
}

TEST_CASE("allocations of other threads are counted") {
  CHECK(allocations_of([] {
          std::thread other([] {
            for (int i = 0; i < 100; ++i) std::free(seen(std::malloc(40)));
          });
          other.join();
        }) >= 100);
}

}  // namespace aspect
