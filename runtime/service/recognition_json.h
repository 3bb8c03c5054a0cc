// What was recognised in a frame as one line of JSON: the runtime's output, for scripts.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "runtime/recognition/recogniser.h"

namespace aspect {

// What only a live camera's frame has.
struct CaptureLabel {
  double time_s = 0;                              // when it was taken, since 1970
  std::chrono::nanoseconds latency{};             // from then to the result
  std::uint64_t late = 0, lost = 0, damaged = 0;  // frames since the last one that are not shown
};

struct FrameLabel {
  std::string_view name;
  std::uint64_t sequence = 0;
  int width_px = 0, height_px = 0;
  std::optional<CaptureLabel> capture{};
};

// Writes the line, its end included, and returns its length. A line that is longer than `out` is
// cut to the best hypotheses of every object, at last to the largest objects; the keys
// "hypotheses_cut" and "objects_cut" then count what is missing. 0: not even a line without objects
// fits. Key "left_undone" only where there is something. `explanations`, JSON values, are the
// objects' in their order, where there are any. `indexes` are those of the recogniser. Allocates
// nothing; O(log(objects + top)) lines.
std::size_t write_recognition_json(const FrameLabel& frame, const Recognition& recognition,
                                   std::span<const ClassIndex> indexes, std::span<char> out,
                                   std::span<const std::string> explanations = {}) noexcept;

// A contour's name from its place in its class: A to Z, then AA, AB and so on. The text lives as
// long as `buffer`.
std::string_view contour_name(std::uint16_t place, std::span<char, 4> buffer);

}  // namespace aspect
