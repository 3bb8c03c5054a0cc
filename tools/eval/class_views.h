// Where the classes of an index lie on the viewing sphere, and which are the same for an observer
// who cannot tell the object's rotations apart.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/viewsphere/patch_division.h"
#include "runtime/recognition/class_index.h"

namespace aspect {

class ClassViews {
 public:
  static Result<ClassViews> create(const ClassIndex& index);

  // The class with the view nearest to this unit vector (thesis 4.4.1); its views are the corners
  // of its patches. Where that view belongs to several, the one of them whose patch has the nearest
  // centre. O(patches).
  std::int32_t nearest(const Eigen::Vector3d& direction) const;
  // The class whose patch or piece the direction lies in, or kNoClass. O(level).
  std::int32_t at(const Eigen::Vector3d& direction) const;
  // The class that a view from there is of: that of the patch or piece of a patch that it lies in,
  // or where the map has none, the nearest.
  std::int32_t right(const Eigen::Vector3d& direction) const;
  // The centre of the class's patch that is nearest to the direction; a class whose patches are not
  // on the map gives the direction itself. O(patches).
  Eigen::Vector3d patch_centre(std::int32_t class_id, const Eigen::Vector3d& direction) const;

 private:
  struct OwnedPatch {
    std::int32_t class_id = kNoClass;
    std::array<Eigen::Vector3d, 3> corners;
    Eigen::Vector3d centre;
  };
  SphereMap map_;
  std::vector<OwnedPatch> patches_;
};

// Which classes are the same because a rotation takes the typical view of one into the other.
//
// Typical views are corners of patches, and many rotations take corners to corners, where patches
// of several classes meet. So it is the centre of the patch beside it that is rotated.
class ClassSymmetry {
 public:
  ClassSymmetry(const ClassIndex& index, const ClassViews& views,
                std::span<const Eigen::Matrix3d> rotations);
  bool same(std::int32_t a, std::int32_t b) const;

 private:
  std::size_t class_count_;
  std::vector<bool> same_;  // square
};

}  // namespace aspect
