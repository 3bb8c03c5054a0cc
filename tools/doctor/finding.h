// What the doctor says about a model.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace aspect {

enum class Severity : std::uint8_t {
  note,     // worth knowing
  warning,  // costs accuracy, or hints at a fault of the export
  error,    // what is compiled is not what is meant
};
std::string_view severity_name(Severity severity);

struct Finding {
  std::string_view group;  // topology, placement, colours or visibility
  std::string_view code;   // of the disease; never renamed, scripts rely on it
  Severity severity = Severity::warning;
  std::string message;    // one line with the numbers
  std::string cure;       // one line
  std::size_t count = 0;  // of what is wrong
  // Some of the places: faces of a mesh (triangles as read) or primitives of a Bob scene, from 1.
  std::vector<std::size_t> where;
  bool can_fix = false;
  std::vector<std::string> names = {};  // that the file has for these places; may be fewer

  static constexpr std::size_t kMostPlaces = 10;
};

}  // namespace aspect
