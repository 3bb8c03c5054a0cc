#include "tools/report/object_axes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aspect {
namespace {

constexpr double kSameAxis = 0.9994;  // cosine of 2 degrees, as far as rotations are told apart

Eigen::Vector3d upright(const Eigen::Vector3d& axis) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0 ? Eigen::Vector3d(-axis) : axis;
}

}  // namespace

std::vector<ObjectAxis> object_axes(const Symmetries& symmetries) {
  std::vector<ObjectAxis> axes;
  for (const Eigen::Vector3d& axis : symmetries.axes) axes.push_back({upright(axis), 0});
  for (const Eigen::Quaterniond& rotation : symmetries.rotations) {
    const Eigen::AngleAxisd turn(rotation);
    const Eigen::Vector3d direction = upright(turn.axis());
    const int fold = static_cast<int>(std::lround(2 * std::numbers::pi / std::abs(turn.angle())));
    const auto same = std::find_if(axes.begin(), axes.end(), [&](const ObjectAxis& axis) {
      return std::abs(axis.direction.dot(direction)) > kSameAxis;
    });
    // Of all turns about one axis the smallest says how many there are.
    if (same == axes.end())
      axes.push_back({direction, fold});
    else if (same->fold != 0)
      same->fold = std::max(same->fold, fold);
  }
  std::stable_sort(axes.begin(), axes.end(), [](const ObjectAxis& a, const ObjectAxis& b) {
    return (a.fold == 0 ? 1000 : a.fold) > (b.fold == 0 ? 1000 : b.fold);
  });
  return axes;
}

}  // namespace aspect
