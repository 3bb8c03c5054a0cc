#include "compiler/scene/missing_colour.h"

#include <fmt/format.h>

namespace aspect {

std::string line_of(const MissingColour& missing) {
  const std::string line = missing.line == 0 ? "" : fmt::format("{}:", missing.line);
  return fmt::format("{}:{} {}", missing.file, line, missing.what);
}

std::string refusal_of(const MissingColour& missing) {
  return fmt::format("{}; {}{}", line_of(missing), missing.cure, kOrGoOn);
}

}  // namespace aspect
