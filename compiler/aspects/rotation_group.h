// Finite groups of rotations, and the axes that models like to be built about.
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace aspect {

// The smallest angle between two rotations, 0 to pi.
double angle_between_rad(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

// A rotation by 2 pi / fold about a unit axis.
Eigen::Quaterniond turn_of(const Eigen::Vector3d& axis, int fold);

// Edges, diagonals of faces and of the body of a cube along the axes of coordinates: 13 unit
// vectors, one of each pair of opposite ones.
const std::vector<Eigen::Vector3d>& cube_axes();

class RotationGroup {
 public:
  // The rotation is one of the group, within 2 degrees.
  bool contains(const Eigen::Quaterniond& rotation) const;

  // Adds the rotation and all products. Where they are more than kMost, which no n-fold object up
  // to 36 sides has, the group stays as it was and the answer is false.
  bool add(const Eigen::Quaterniond& rotation);

  // The identity first, then by angle, then by axis; w >= 0.
  std::vector<Eigen::Quaterniond> elements() const;

  static constexpr std::size_t kMost = 72;

 private:
  std::vector<Eigen::Quaterniond> elements_{Eigen::Quaterniond::Identity()};
};

}  // namespace aspect
