#include "tools/eval/class_views.h"

#include <algorithm>
#include <limits>

namespace aspect {

Result<ClassViews> ClassViews::create(const ClassIndex& index) {
  ClassViews views;
  views.map_ = index.sphere_map;
  for (const SphereMap::Leaf& leaf : views.map_.leaves()) {
    OwnedPatch owned;
    owned.class_id = leaf.class_id;
    if (owned.class_id == kNoClass) continue;
    for (std::size_t k = 0; k < 3; ++k)
      owned.corners[k] =
          Eigen::Vector3d(leaf.corners[k][0], leaf.corners[k][1], leaf.corners[k][2]);
    owned.centre = (owned.corners[0] + owned.corners[1] + owned.corners[2]).normalized();
    views.patches_.push_back(owned);
  }
  if (views.patches_.empty())
    return Error{"its map of the viewing sphere holds no class; compile the scene again"};
  return views;
}

std::int32_t ClassViews::nearest(const Eigen::Vector3d& direction) const {
  constexpr double kFar = -std::numeric_limits<double>::infinity();
  double best_corner = kFar, best_centre = kFar;
  std::int32_t found = kNoClass;
  for (const OwnedPatch& patch : patches_) {
    double corner = kFar;
    for (const Eigen::Vector3d& position : patch.corners)
      corner = std::max(corner, position.dot(direction));
    if (corner < best_corner) continue;
    const double centre = patch.centre.dot(direction);
    if (corner == best_corner && centre <= best_centre) continue;
    best_corner = corner;
    best_centre = centre;
    found = patch.class_id;
  }
  return found;
}

std::int32_t ClassViews::at(const Eigen::Vector3d& direction) const {
  return map_.class_at({direction.x(), direction.y(), direction.z()});
}

std::int32_t ClassViews::right(const Eigen::Vector3d& direction) const {
  const std::int32_t inside = at(direction);
  return inside == kNoClass ? nearest(direction) : inside;
}

Eigen::Vector3d ClassViews::patch_centre(std::int32_t class_id,
                                         const Eigen::Vector3d& direction) const {
  double best = -std::numeric_limits<double>::infinity();
  Eigen::Vector3d found = direction;
  for (const OwnedPatch& patch : patches_) {
    const double cosine = patch.centre.dot(direction);
    if (patch.class_id != class_id || cosine <= best) continue;
    best = cosine;
    found = patch.centre;
  }
  return found;
}

ClassSymmetry::ClassSymmetry(const ClassIndex& index, const ClassViews& views,
                             std::span<const Eigen::Matrix3d> rotations)
    : class_count_(index.classes.size()), same_(class_count_ * class_count_, false) {
  for (std::size_t c = 0; c < class_count_; ++c) {
    same_[c * class_count_ + c] = true;
    const Vector3& v = index.classes[c].view;
    const Eigen::Vector3d typical = views.patch_centre(
        static_cast<std::int32_t>(c), Eigen::Vector3f(v[0], v[1], v[2]).cast<double>());
    for (const Eigen::Matrix3d& rotation : rotations) {
      const Eigen::Vector3d turned = rotation * typical;
      const auto other = static_cast<std::size_t>(views.right(turned));
      same_[c * class_count_ + other] = same_[other * class_count_ + c] = true;
    }
  }
}

bool ClassSymmetry::same(std::int32_t a, std::int32_t b) const {
  return same_[static_cast<std::size_t>(a) * class_count_ + static_cast<std::size_t>(b)];
}

}  // namespace aspect
