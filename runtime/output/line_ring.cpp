// A sequence lock without the lock: the writer says which words it is going to overwrite, writes
// them, then counts the line; a reader copies and then looks whether what it copied had been given
// up meanwhile. All words are atomic, so that a copy in vain is no data race (Boehm, "Can seqlocks
// get along with programming language memory models?", 2012).
#include "runtime/output/line_ring.h"

#include <algorithm>
#include <cstring>

namespace aspect {
namespace {

constexpr unsigned kLengthBits = 16;
static_assert(LineRing::kMaxLineBytes < (1U << kLengthBits));

}  // namespace

LineRing::LineRing() : words_(kWords) {}

bool LineRing::publish(std::string_view line) noexcept {
  if (line.size() > kMaxLineBytes || line.empty() || line.find('\n') != line.size() - 1)
    return false;
  const std::uint64_t number = published_.load(std::memory_order_relaxed);
  const std::uint64_t begin = words_begun_.load(std::memory_order_relaxed);
  const std::size_t words = (line.size() + sizeof(Word) - 1) / sizeof(Word);
  lines_begun_.store(number + 1, std::memory_order_relaxed);
  words_begun_.store(begin + words, std::memory_order_relaxed);
  std::atomic_thread_fence(std::memory_order_release);
  for (std::size_t k = 0; k < words; ++k) {
    const std::size_t offset = k * sizeof(Word);
    Word word = 0;
    std::memcpy(&word, line.data() + offset, std::min(sizeof word, line.size() - offset));
    words_[(begin + k) % kWords].store(word, std::memory_order_relaxed);
  }
  places_[number % kLines].store(begin << kLengthBits | line.size(), std::memory_order_relaxed);
  published_.store(number + 1, std::memory_order_release);
  return true;
}

std::uint64_t LineRing::published() const noexcept {
  return published_.load(std::memory_order_acquire);
}

LineRing::Reading LineRing::read(std::uint64_t number, LineBuffer buffer) const noexcept {
  if (number >= published()) return {Reading::State::not_yet, {}};
  const std::uint64_t place = places_[number % kLines].load(std::memory_order_relaxed);
  const std::uint64_t begin = place >> kLengthBits;
  const std::size_t size = std::min<std::size_t>(place & ((1U << kLengthBits) - 1), buffer.size());
  for (std::size_t offset = 0; offset < size; offset += sizeof(Word)) {
    const Word word =
        words_[(begin + offset / sizeof(Word)) % kWords].load(std::memory_order_relaxed);
    std::memcpy(buffer.data() + offset, &word, std::min(sizeof word, size - offset));
  }
  std::atomic_thread_fence(std::memory_order_acquire);
  const bool gone = lines_begun_.load(std::memory_order_relaxed) > number + kLines ||
                    words_begun_.load(std::memory_order_relaxed) > begin + kWords;
  if (gone) return {Reading::State::gone, {}};
  return {Reading::State::line, {buffer.data(), size}};
}

std::uint64_t LineRing::restart() const noexcept {
  const std::uint64_t end = words_begun_.load(std::memory_order_relaxed);
  const std::uint64_t newest = published();
  std::uint64_t number = newest;
  while (number > 0 && newest - number < kLines / 2) {
    const std::uint64_t place = places_[(number - 1) % kLines].load(std::memory_order_relaxed);
    // A place that was taken by a newer line meanwhile lies beyond the end: that ends it as well.
    if (end - (place >> kLengthBits) > kWords / 2) break;
    --number;
  }
  return number;
}

}  // namespace aspect
