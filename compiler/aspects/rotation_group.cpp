#include "compiler/aspects/rotation_group.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace aspect {
namespace {

constexpr double kSame_rad = 2 * std::numbers::pi / 180;

bool holds(const std::vector<Eigen::Quaterniond>& all, const Eigen::Quaterniond& one) {
  return std::any_of(all.begin(), all.end(), [&](const Eigen::Quaterniond& other) {
    return angle_between_rad(one, other) < kSame_rad;
  });
}

// Rounding noise at 0 would make the sign a matter of chance.
Eigen::Quaterniond canonical(const Eigen::Quaterniond& rotation) {
  for (const double x : {rotation.w(), rotation.x(), rotation.y(), rotation.z()}) {
    if (std::abs(x) < 1e-9) continue;
    return x > 0 ? rotation : Eigen::Quaterniond(-rotation.coeffs());
  }
  return rotation;
}

std::array<long, 4> order_of(const Eigen::Quaterniond& q) {
  const auto rounded = [](double x) { return std::lround(x * 1e6); };
  return {-rounded(q.w()), -rounded(q.x()), -rounded(q.y()), -rounded(q.z())};
}

}  // namespace

double angle_between_rad(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const Eigen::Quaterniond d = a.conjugate() * b;
  return 2 * std::atan2(d.vec().norm(), std::abs(d.w()));
}

Eigen::Quaterniond turn_of(const Eigen::Vector3d& axis, int fold) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(2 * std::numbers::pi / fold, axis));
}

const std::vector<Eigen::Vector3d>& cube_axes() {
  static const std::vector<Eigen::Vector3d> axes = [] {
    std::vector<Eigen::Vector3d> found = {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(),
                                          Eigen::Vector3d::UnitZ()};
    for (const double s : {1.0, -1.0}) {
      found.push_back(Eigen::Vector3d(1, s, 0).normalized());
      found.push_back(Eigen::Vector3d(1, 0, s).normalized());
      found.push_back(Eigen::Vector3d(0, 1, s).normalized());
      for (const double t : {1.0, -1.0}) found.push_back(Eigen::Vector3d(1, s, t).normalized());
    }
    return found;
  }();
  return axes;
}

bool RotationGroup::contains(const Eigen::Quaterniond& rotation) const {
  return holds(elements_, rotation);
}

bool RotationGroup::add(const Eigen::Quaterniond& rotation) {
  std::vector<Eigen::Quaterniond> closed = elements_;
  if (!holds(closed, rotation)) closed.push_back(rotation);
  for (std::size_t a = 0; a < closed.size(); ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      for (const Eigen::Quaterniond& product : {closed[a] * closed[b], closed[b] * closed[a]})
        if (!holds(closed, product)) closed.push_back(product.normalized());
      if (closed.size() > kMost) return false;
    }
  }
  elements_ = std::move(closed);
  return true;
}

std::vector<Eigen::Quaterniond> RotationGroup::elements() const {
  std::vector<Eigen::Quaterniond> sorted;
  for (const Eigen::Quaterniond& element : elements_) sorted.push_back(canonical(element));
  std::sort(sorted.begin(), sorted.end(),
            [](const auto& a, const auto& b) { return order_of(a) < order_of(b); });
  return sorted;
}

}  // namespace aspect
