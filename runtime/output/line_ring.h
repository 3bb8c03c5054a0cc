// The newest lines, for any number of readers: one thread writes and never waits, a reader that
// comes too late is told so.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace aspect {

class LineRing {
 public:
  static constexpr std::size_t kBytes = 256U << 10U;  // of text, each line rounded up to a word
  static constexpr std::size_t kLines = 1024;
  static constexpr std::size_t kMaxLineBytes = 32U << 10U;
  using LineBuffer = std::span<char, kMaxLineBytes>;

  LineRing();

  // Lines are numbered from 0. False, and nothing done, unless the line ends with its only line
  // break and has at most kMaxLineBytes. Always from the same thread; O(bytes).
  bool publish(std::string_view line) noexcept;

  // How many there were: the number of the next one.
  std::uint64_t published() const noexcept;

  struct Reading {
    enum class State : std::uint8_t { line, not_yet, gone } state = State::not_yet;
    std::string_view line;  // in the buffer
  };
  Reading read(std::uint64_t number, LineBuffer buffer) const noexcept;

  // Where to go on if the line wanted is gone: half a ring behind the newest, so that the next one
  // is not gone at once.
  std::uint64_t restart() const noexcept;

 private:
  using Word = std::size_t;
  static constexpr std::size_t kWords = kBytes / sizeof(Word);

  std::vector<std::atomic<Word>> words_;
  std::array<std::atomic<std::uint64_t>, kLines> places_{};  // first word << 16 | bytes
  // What is being overwritten: set before, as `published_` is set after.
  std::atomic<std::uint64_t> lines_begun_{0}, words_begun_{0};
  std::atomic<std::uint64_t> published_{0};
};

}  // namespace aspect
