#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "tools/aspectc/commands/models_info_command.h"

namespace aspect {
namespace {

using Json = nlohmann::ordered_json;

// What comes of rounding to single precision and should be 0 or 1.
double tidied(double x) {
  return std::abs(x - std::round(x)) < 1e-6 ? std::round(x) + 0.0 : x;
}

// Row by row, a turn about the centre: x -> R (x - c) + c.
Json matrix_json(const std::array<float, 4>& wxyz, const Eigen::Vector3d& centre) {
  const Eigen::Quaternionf single(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  const Eigen::Matrix3d turn = single.cast<double>().normalized().toRotationMatrix();
  const Eigen::Vector3d shift = centre - turn * centre;
  Json numbers = Json::array();
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column)
      numbers.push_back(tidied(turn(row, column)));
    numbers.push_back(tidied(shift[row]));
  }
  for (const double last : {0.0, 0.0, 0.0, 1.0}) numbers.push_back(last);
  return numbers;
}

Json model_json(const ClassIndex& index) {
  const ObjectExtent& extent = index.extent;
  Json json{{"name", index.object}, {"diameter", extent.diameter}};
  const std::array<std::string, 3> axes = {"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k) json["min_" + axes[k]] = extent.least[k];
  for (std::size_t k = 0; k < 3; ++k) json["size_" + axes[k]] = extent.most[k] - extent.least[k];
  for (const std::array<float, 4>& rotation : index.symmetries)
    json["symmetries_discrete"].push_back(
        matrix_json(rotation, Eigen::Vector3d(extent.centre.data())));
  for (const Vector3& axis : index.symmetry_axes)
    json["symmetries_continuous"].push_back({{"axis", axis}, {"offset", extent.centre}});
  return json;
}

}  // namespace

std::string models_info_json(std::span<const ClassIndex> indexes) {
  Json json = Json::object();
  for (std::size_t k = 0; k < indexes.size(); ++k)
    json[std::to_string(k + 1)] = model_json(indexes[k]);
  return json.dump(2) + "\n";
}

}  // namespace aspect
