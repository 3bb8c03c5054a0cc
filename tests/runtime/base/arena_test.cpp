#include "runtime/base/arena.h"

#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

#include "tests/runtime/base/aborting.h"

namespace aspect {
namespace {

struct alignas(64) CacheLine {
  std::array<std::byte, 64> bytes;
};

// A plan of several takes of odd sizes, so that padding counts.
std::size_t take_plan(Arena& arena) {
  arena.take<std::uint8_t>(3);
  arena.take<double>(5);
  arena.take<std::uint16_t>(0);
  arena.take<std::uint32_t>(33);
  arena.take<std::uint8_t>(65);
  return arena.used_bytes();
}

}  // namespace

TEST_CASE("an arena without storage counts and hands out nothing") {
  Arena arena;
  REQUIRE(arena.take<std::uint32_t>(10).empty());
  REQUIRE(arena.used_bytes() == 40);
}

TEST_CASE("a counting arena and a real one agree") {
  Arena counting;
  const std::size_t bytes = take_plan(counting);
  std::vector<CacheLine> storage((bytes + 63) / 64);
  Arena real(std::as_writable_bytes(std::span(storage)).first(bytes));
  REQUIRE(take_plan(real) == bytes);
}

TEST_CASE("spans start on cache lines, do not overlap and are cleared") {
  std::vector<CacheLine> storage(16);
  for (CacheLine& line : storage) line.bytes.fill(std::byte{0xAB});
  Arena arena(std::as_writable_bytes(std::span(storage)));
  const auto a = arena.take<std::uint8_t>(3);
  const auto b = arena.take<std::uint32_t>(17);
  const auto c = arena.take<double>(2);
  for (const void* first : {static_cast<const void*>(a.data()), static_cast<const void*>(b.data()),
                            static_cast<const void*>(c.data())})
    REQUIRE(reinterpret_cast<std::uintptr_t>(first) % 64 == 0);
  REQUIRE(a.size() == 3);
  REQUIRE(b.size() == 17);
  for (const std::uint32_t value : b) REQUIRE(value == 0);
  for (std::uint32_t& value : b) value = 0xFFFFFFFF;
  for (const std::uint8_t value : a) REQUIRE(value == 0);
  for (const double value : c) REQUIRE(value == 0);
}

TEST_CASE("elements get the values of their default members") {
  struct Seven {
    int value = 7;
  };
  std::vector<CacheLine> storage(4);
  Arena arena(std::as_writable_bytes(std::span(storage)));
  for (const Seven& seven : arena.take<Seven>(20)) REQUIRE(seven.value == 7);
}

TEST_CASE("an arena can be used up to its last byte and not beyond") {
  std::vector<CacheLine> storage(2);
  const auto bytes = std::as_writable_bytes(std::span(storage));
  Arena arena(bytes);
  REQUIRE(arena.take<std::uint8_t>(128).size() == 128);
  REQUIRE(aborts([&] { arena.take<std::uint8_t>(1); }));
  REQUIRE(aborts([&] {
    Arena too_small(bytes.first(127));
    too_small.take<std::uint8_t>(128);
  }));
}

TEST_CASE("a sealed arena refuses, with storage and without") {
  Arena arena;
  arena.take<int>(1);
  REQUIRE_FALSE(aborts([&] { arena.take<int>(1); }));
  arena.seal();
  REQUIRE(aborts([&] { arena.take<int>(1); }));
  REQUIRE(arena.used_bytes() == sizeof(int));
}

}  // namespace aspect
