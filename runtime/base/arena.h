// Caller-owned memory from which a stage takes all it will ever need, before the first frame.
// After seal() a request is a bug of ours and aborts: the per-frame path allocates nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <type_traits>

#include "runtime/base/check.h"

namespace aspect {

class Arena {
 public:
  // An arena without storage only counts: use it to learn how many bytes a plan needs.
  Arena() = default;
  explicit Arena(std::span<std::byte> storage) : storage_(storage) {}

  // `count` value-initialised elements on a cache-line boundary. Empty where there is no storage.
  template <typename T>
  std::span<T> take(std::size_t count) {
    static_assert(std::is_trivially_destructible_v<T>);
    ASPECT_CHECK(!sealed_);
    const std::size_t begin = (used_bytes_ + kAlignment - 1) / kAlignment * kAlignment;
    used_bytes_ = begin + count * sizeof(T);
    if (storage_.empty()) return {};
    ASPECT_CHECK(used_bytes_ <= storage_.size());
    T* first = reinterpret_cast<T*>(storage_.data() + begin);
    for (std::size_t i = 0; i < count; ++i) new (first + i) T{};
    return {first, count};
  }

  void seal() { sealed_ = true; }
  std::size_t used_bytes() const { return used_bytes_; }

 private:
  static constexpr std::size_t kAlignment = 64;
  std::span<std::byte> storage_;
  std::size_t used_bytes_ = 0;
  bool sealed_ = false;
};

}  // namespace aspect
