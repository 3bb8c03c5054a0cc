// The rotations that leave objects as they are, from a symmetries file.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/result.h"

namespace aspect {

class KnownRotations {
 public:
  // The identity alone for every object.
  KnownRotations() = default;

  // Each row or table is one turn; any angle stands for those of whole degrees. Powers and products
  // of turns are not added: list them.
  static Result<KnownRotations> read(const std::filesystem::path& file);
  static Result<KnownRotations> parse_csv(std::string_view text, const std::string& name);
  static Result<KnownRotations> parse_toml(std::string_view text, const std::string& name);

  // Angle between a true and a found view (unit vectors), modulo the object's rotations.
  double view_error_deg(const std::string& object, const Eigen::Vector3d& truth,
                        const Eigen::Vector3d& found) const;

 private:
  // Without degrees: any angle.
  void add(const std::string& object, const Eigen::Vector3d& axis, std::optional<double> degrees);
  std::map<std::string, std::vector<Eigen::Matrix3d>> turns_;
};

}  // namespace aspect
