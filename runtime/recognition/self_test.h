// The test at power-on: every index's golden frame (golden_frame.h) is recognised again and must
// get the answer that it got when the index was compiled.
//
// Together with the checksum, which the loader checks, this finds damaged files, damaged programs
// and a program that another version of the compiler wrote for.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "runtime/base/result.h"
#include "runtime/recognition/class_index.h"
#include "runtime/recognition/recogniser.h"

namespace aspect {

// Scores of a sound program differ by rounding alone: 1e-7 from one architecture to another.
inline constexpr double kGoldenScoreTolerance = 1e-3;

// What an index alone answers to its golden frame, whose foreground is one object.
struct GoldenAnswer {
  int regions = 0;
  std::optional<Hypothesis> best;  // both without their contours
  std::optional<Hypothesis> own;   // of the class that is expected
  double rival_score = 0;          // the best of the other classes
};

// With the parameters that it was compiled with; the golden frame must be sound. Takes memory for
// the picture and for a recogniser of its size from the arena: see self_test_bytes.
GoldenAnswer golden_answer(const ClassIndex& index, const GoldenFrame& golden, Arena& arena);
// With memory of its own, given back on return. May throw std::bad_alloc.
GoldenAnswer golden_answer(const ClassIndex& index, const GoldenFrame& golden);

// The expected class is the best one with the expected score. Of a symmetric object's classes that
// score alike, any may come first.
bool is_expected(const GoldenAnswer& answer, const GoldenFrame& golden);

struct SelfTestResult {
  enum class Outcome { passed, absent, failed } outcome = Outcome::passed;
  std::string line;  // what was tested and found, and where it failed what to do; no line feed
};
SelfTestResult self_test(const ClassIndex& index);

// The line of the first index that fails. One without a golden frame passes.
std::optional<Error> self_test(std::span<const ClassIndex> indexes);

// The same in memory that is used for something else later, of at least self_test_bytes and on a
// cache line's boundary. About 35 bytes a pixel of the largest golden frame: 5 MB, less than the
// recogniser of a camera of 640 x 480 pixels takes.
std::size_t self_test_bytes(std::span<const ClassIndex> indexes);
std::optional<Error> self_test(std::span<const ClassIndex> indexes, std::span<std::byte> memory);

}  // namespace aspect
