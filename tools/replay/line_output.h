// Lines on standard output, each seen by the reader as soon as it is written.
#pragma once

#include <string_view>

namespace aspect {

enum class OutputStatus { written, closed, failed };

// closed: the reader has gone or there never was one. failed: errno says why. SIGPIPE must be
// ignored.
[[nodiscard]] OutputStatus write_line(std::string_view line);

// To be called first: standard streams that the caller closed are given a file that only fails, so
// that no picture opened later takes their place.
void guard_standard_streams();

}  // namespace aspect
