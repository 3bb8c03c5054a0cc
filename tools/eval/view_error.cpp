#include "tools/eval/view_error.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace aspect {

std::vector<Eigen::Matrix3d> index_rotations(const ClassIndex& index) {
  std::vector<Eigen::Matrix3d> rotations{Eigen::Matrix3d::Identity()};
  for (const std::array<float, 4>& q : index.symmetries)
    rotations.push_back(
        Eigen::Quaternionf(q[0], q[1], q[2], q[3]).cast<double>().normalized().toRotationMatrix());
  // Three round axes are those of a ball; turns about two of them reach every view.
  const std::size_t axes = std::min<std::size_t>(index.symmetry_axes.size(), 2);
  for (std::size_t a = 0; a < axes; ++a) {
    const Vector3& v = index.symmetry_axes[a];
    const Eigen::Vector3d axis = Eigen::Vector3f(v[0], v[1], v[2]).cast<double>().normalized();
    const int step_deg = axes == 1 ? 1 : 5;
    const std::size_t count = rotations.size();
    for (int angle_deg = step_deg; angle_deg < 360; angle_deg += step_deg)
      for (std::size_t k = 0; k < count; ++k)
        rotations.emplace_back(
            Eigen::AngleAxisd(angle_deg * std::numbers::pi / 180, axis).toRotationMatrix() *
            rotations[k]);
  }
  return rotations;
}

double angle_rad(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::acos(std::clamp(a.dot(b), -1.0, 1.0));
}

double view_error_rad(const std::vector<Eigen::Matrix3d>& rotations, const Eigen::Vector3d& truth,
                      const Eigen::Vector3d& found) {
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Matrix3d& rotation : rotations)
    least = std::min(least, angle_rad(rotation * truth, found));
  return least;
}

}  // namespace aspect
