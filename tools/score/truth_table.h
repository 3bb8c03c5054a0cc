// truth.csv: which objects a frame shows, where, and from where they are seen.
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/result.h"

namespace aspect {

using PixelBox = std::array<double, 4>;  // x, y, width, height

struct TrueObject {
  std::string object;
  Eigen::Vector3d view;  // unit vector from the object's centre to the camera, object coordinates
  PixelBox box{};
  double visible = 1;  // share of it that is not covered or cut off
};

struct TrueFrame {
  std::string file;
  std::vector<TrueObject> objects;
};

// In the order of the frames' first rows. Errors name file and line.
Result<std::vector<TrueFrame>> read_truth(const std::filesystem::path& file);
Result<std::vector<TrueFrame>> parse_truth(std::string_view text, const std::string& name);

// A CSV file without quoted fields: rows of fields, with the number of the line they stand on.
// Empty lines are left out.
struct CsvRow {
  int line = 0;
  std::vector<std::string> fields;
};
std::vector<CsvRow> csv_rows(std::string_view text);
std::optional<double> finite_number(std::string_view field);
Result<std::string> read_text(const std::filesystem::path& file);

}  // namespace aspect
