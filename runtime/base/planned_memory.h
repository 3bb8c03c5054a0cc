// Memory for whatever plans its own with an arena.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "runtime/base/arena.h"

namespace aspect {

class PlannedMemory {
 public:
  // Calls prepare(Arena&) twice: to count the bytes, and to take them. What it took before is gone.
  template <typename Prepare>
  void plan(Prepare&& prepare) {
    Arena counting;
    prepare(counting);
    lines_.assign((counting.used_bytes() + sizeof(Line) - 1) / sizeof(Line), Line{});
    Arena arena(std::as_writable_bytes(std::span(lines_)));
    prepare(arena);
    arena.seal();
    bytes_ = arena.used_bytes();
  }

  std::size_t bytes() const { return bytes_; }

 private:
  struct alignas(64) Line {
    std::byte bytes[64];
  };
  std::vector<Line> lines_;
  std::size_t bytes_ = 0;
};

}  // namespace aspect
