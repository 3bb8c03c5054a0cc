// The statements that are primitives: polygon, patch, sphere, ring, cone and cylinder.
#pragma once

#include <cstddef>
#include <optional>

#include "compiler/scene/bob_block.h"
#include "compiler/scene/bob_numbers.h"
#include "compiler/scene/bob_transforms.h"
#include "compiler/scene/bob_words.h"
#include "compiler/scene/scene.h"

namespace aspect {

// Reads a primitive, checks it and gives it in scene coordinates. Throws BobError.
class BobShapes {
 public:
  using Shape = decltype(Primitive::shape);

  // All polygons of a scene together.
  static constexpr std::size_t kMaxPoints = 1'000'000;

  BobShapes(BobWords& words, BobNumbers& numbers, BobWarnings& warnings,
            const BobTransforms& transforms)
      : words_(words), numbers_(numbers), warnings_(warnings), transforms_(transforms) {}

  // Nothing where the statement is no primitive.
  std::optional<Shape> read(const BobWord& statement);

 private:
  Polygon read_polygon(const BobWord& statement);
  SmoothTriangle read_patch(const BobWord& statement);
  Sphere read_sphere(const BobWord& statement);
  Ring read_ring(const BobWord& statement);
  Cone read_cone(const BobWord& statement);

  std::size_t read_point_count(const BobWord& word);
  void check_patch(const SmoothTriangle& patch, const BobWord& statement) const;
  void check_polygon(const Polygon& polygon, const BobWord& statement) const;
  void check_radius(double radius, std::string_view name, const BobWord& statement) const;
  BobBlock block(const BobWord& statement) { return {words_, numbers_, warnings_, statement}; }

  // How lengths of a round primitive grow.
  double round_factor(const BobWord& statement) const;
  Eigen::Vector3d placed(const Eigen::Vector3d& written, const BobWord& statement) const;
  double placed_radius(double written, const BobWord& statement) const;

  BobWords& words_;
  BobNumbers& numbers_;
  BobWarnings& warnings_;
  const BobTransforms& transforms_;
  std::size_t points_ = 0;
};

}  // namespace aspect
