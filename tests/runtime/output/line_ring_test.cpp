#include "runtime/output/line_ring.h"

#include <array>
#include <catch2/catch.hpp>
#include <thread>

#include "tests/runtime/output/made_lines.h"

namespace aspect {
namespace {

using State = LineRing::Reading::State;

}  // namespace

TEST_CASE("a ring gives back its lines until they are overwritten") {
  constexpr std::size_t kLongest = 3000;
  LineRing ring;
  std::array<char, LineRing::kMaxLineBytes> buffer;
  CHECK(ring.read(0, buffer).state == State::not_yet);
  for (std::uint64_t number = 0; number < 5000; ++number) {
    REQUIRE(ring.publish(made_line(number, kLongest)));
    REQUIRE(ring.read(number + 1, buffer).state == State::not_yet);
    // A sixteenth of the ring is always there still.
    const std::uint64_t old = number < 5 ? 0 : number - 5;
    const auto reading = ring.read(old, buffer);
    REQUIRE(reading.state == State::line);
    REQUIRE(reading.line == made_line(old, kLongest));
  }
  CHECK(ring.read(0, buffer).state == State::gone);
  const std::uint64_t restart = ring.restart();
  CHECK(ring.read(restart, buffer).state == State::line);
  std::size_t bytes = 0;
  for (std::uint64_t number = restart; number < 5000; ++number)
    bytes += made_line(number, kLongest).size();
  CHECK(bytes > LineRing::kBytes / 2 - 2 * kLongest);
  CHECK(bytes <= LineRing::kBytes / 2);
}

TEST_CASE("short lines are limited by their number") {
  LineRing ring;
  std::array<char, LineRing::kMaxLineBytes> buffer;
  for (std::uint64_t number = 0; number < 2 * LineRing::kLines; ++number)
    REQUIRE(ring.publish(made_line(number, 20)));
  CHECK(ring.read(LineRing::kLines - 1, buffer).state == State::gone);
  const auto oldest = ring.read(LineRing::kLines, buffer);
  REQUIRE(oldest.state == State::line);
  CHECK(number_of(oldest.line, 20) == LineRing::kLines);
}

TEST_CASE("only whole lines of a bearable length are taken") {
  LineRing ring;
  CHECK_FALSE(ring.publish(""));
  CHECK_FALSE(ring.publish("without an end"));
  CHECK_FALSE(ring.publish("two\nlines\n"));
  std::string longest(LineRing::kMaxLineBytes, 'x');
  longest.back() = '\n';
  CHECK(ring.publish(longest));
  CHECK_FALSE(ring.publish("x" + longest));
  CHECK(ring.published() == 1);
}

TEST_CASE("what readers copy while the ring is overwritten is whole or refused") {
  constexpr std::size_t kLongest = 20000;
  constexpr std::uint64_t kLines = 20000;
  LineRing ring;
  std::array<std::uint64_t, 2> whole{}, gone{}, broken{};
  const auto read_all = [&](std::size_t reader) {
    std::array<char, LineRing::kMaxLineBytes> buffer;
    for (std::uint64_t number = 0; number < kLines;) {
      const auto [state, line] = ring.read(number, buffer);
      if (state == State::not_yet) {
        // What writes may have no processor of its own.
        std::this_thread::yield();
        continue;
      }
      if (state == State::line) ++(number_of(line, kLongest) == number ? whole : broken)[reader];
      if (state == State::gone) ++gone[reader];
      // One of them always reads what is about to be overwritten.
      number =
          state == State::gone && reader == 0 ? std::max(ring.restart(), number + 1) : number + 1;
    }
  };
  std::thread first(read_all, 0), second(read_all, 1);
  for (std::uint64_t number = 0; number < kLines; ++number)
    REQUIRE(ring.publish(made_line(number, kLongest)));
  first.join();
  second.join();
  for (const std::size_t reader : {0U, 1U}) {
    CHECK(broken[reader] == 0);
    CHECK(whole[reader] > 0);
  }
}

}  // namespace aspect
