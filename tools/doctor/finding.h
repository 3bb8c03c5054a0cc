// What the doctor says about a model.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace aspect {

enum class Severity : std::uint8_t {
  note,     // worth knowing
  warning,  // costs accuracy, or hints at a fault of the export
  error,    // what is compiled is not what is meant
};
std::string_view severity_name(Severity severity);

// Where a finding is on the object, for pictures: in the coordinates of the scene.
struct FindingMarks {
  // More of a kind cannot be told apart in any picture.
  static constexpr std::size_t kMost = 20'000;

  std::vector<std::array<Eigen::Vector3d, 2>> lines;
  std::vector<std::vector<Eigen::Vector3d>> faces;  // the corners of each
  std::vector<Eigen::Vector3d> points;
  std::vector<std::size_t> primitives;                          // of the scene, from 0
  std::vector<std::pair<std::size_t, std::size_t>> borders;     // of these two primitives
  std::vector<std::pair<std::size_t, std::size_t>> of_colours;  // borders of two ColourGroups

  bool empty() const {
    return lines.empty() && faces.empty() && points.empty() && primitives.empty() &&
           borders.empty() && of_colours.empty();
  }
};

// One of the faults that a finding sums up.
struct FindingExample {
  std::string message;
  std::size_t count = 0;           // how bad it is
  std::vector<std::size_t> where;  // as of a finding
};

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
  FindingMarks marks = {};
  std::vector<FindingExample> examples = {};  // all of what it sums up, the worst first; or none

  static constexpr std::size_t kMostPlaces = 10;
};

}  // namespace aspect
