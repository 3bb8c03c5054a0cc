#include "tools/score/known_rotations.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/score/truth_table.h"

namespace aspect {
namespace {

constexpr const char* kWanted = "object,x,y,z,degrees with an axis other than 0,0,0 was expected";

double angle_deg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::acos(std::clamp(a.dot(b), -1.0, 1.0)) * 180 / std::numbers::pi;
}

}  // namespace

void KnownRotations::add(const std::string& object, const Eigen::Vector3d& axis,
                         std::optional<double> degrees) {
  const auto turn = [&](double angle) {
    turns_[object].push_back(
        Eigen::AngleAxisd(angle * std::numbers::pi / 180, axis.normalized()).toRotationMatrix());
  };
  if (degrees) return turn(*degrees);
  for (int angle = 1; angle < 360; ++angle) turn(angle);
}

Result<KnownRotations> KnownRotations::read(const std::filesystem::path& file) {
  const Result<std::string> text = read_text(file);
  if (!text) return Error{text.error()};
  return file.extension() == ".toml" ? parse_toml(text.value(), file.native())
                                     : parse_csv(text.value(), file.native());
}

Result<KnownRotations> KnownRotations::parse_csv(std::string_view text, const std::string& name) {
  KnownRotations rotations;
  for (const CsvRow& row : csv_rows(text)) {
    const std::vector<std::string> head = {"object", "x", "y", "z", "degrees"};
    if (row.fields == head) continue;
    const auto fault = Error{fmt::format("{}:{}: no symmetry; {}", name, row.line, kWanted)};
    if (row.fields.size() != head.size()) return fault;
    Eigen::Vector3d axis;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto number = finite_number(row.fields[k + 1]);
      if (!number) return fault;
      axis[static_cast<Eigen::Index>(k)] = *number;
    }
    const auto degrees = finite_number(row.fields[4]);
    if (!(axis.norm() > 0) || (!degrees && !row.fields[4].empty())) return fault;
    rotations.add(row.fields[0], axis, degrees);
  }
  return rotations;
}

Result<KnownRotations> KnownRotations::parse_toml(std::string_view text, const std::string& name) {
  KnownRotations rotations;
  try {
    const toml::table root = toml::parse(text, name);
    for (const auto& [key, node] : root)
      if (key.str() != "symmetry" || !node.is_array_of_tables())
        return Error{fmt::format("{}:{}: unknown {}; [[symmetry]] tables were expected", name,
                                 key.source().begin.line, key.str())};
    const toml::array* tables = root["symmetry"].as_array();
    for (std::size_t k = 0; tables != nullptr && k < tables->size(); ++k) {
      const toml::table& table = *tables->get_as<toml::table>(k);
      const auto object = table["object"].value<std::string>();
      const auto x = table["axis"][0].value<double>(), y = table["axis"][1].value<double>(),
                 z = table["axis"][2].value<double>();
      const auto degrees = table["degrees"].value<double>();
      const Eigen::Vector3d axis(x.value_or(0), y.value_or(0), z.value_or(0));
      const bool angle_fits = degrees ? std::isfinite(*degrees) : !table.contains("degrees");
      if (!object || !x || !y || !z || !(axis.norm() > 0) || !axis.allFinite() || !angle_fits)
        return Error{fmt::format(
            "{}:{}: no symmetry; object = \"name\", axis = [x, y, z] and degrees were expected",
            name, table.source().begin.line)};
      rotations.add(*object, axis, degrees);
    }
  } catch (const toml::parse_error& error) {
    return Error{fmt::format("{}:{}: not TOML: {}; mend the line", name, error.source().begin.line,
                             error.description())};
  }
  return rotations;
}

double KnownRotations::view_error_deg(const std::string& object, const Eigen::Vector3d& truth,
                                      const Eigen::Vector3d& found) const {
  double least = angle_deg(truth, found);
  const auto known = turns_.find(object);
  if (known == turns_.end()) return least;
  for (const Eigen::Matrix3d& turn : known->second)
    least = std::min(least, angle_deg(turn * truth, found));
  return least;
}

}  // namespace aspect
