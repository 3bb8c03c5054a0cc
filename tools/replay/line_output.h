// Lines on standard output, each seen by the reader as soon as it is written.
#pragma once

#include <string_view>

namespace aspect {

enum class OutputStatus { written, closed, failed };

// closed: the reader has gone or there never was one. failed: errno says why. SIGPIPE must be
// ignored.
[[nodiscard]] OutputStatus write_line(std::string_view line);

}  // namespace aspect
