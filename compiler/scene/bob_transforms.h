// The stack of transforms that a scene's primitives stand in.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "compiler/scene/bob_numbers.h"
#include "compiler/scene/bob_words.h"

namespace aspect {

class BobTransforms {
 public:
  BobTransforms(BobWords& words, BobNumbers& numbers) : words_(words), numbers_(numbers) {}

  // Reads `{ translate V rotate V scale V ... }` behind the word transform.
  void push(const BobWord& statement);
  void pop(const BobWord& statement);
  // Fails where a transform was not popped.
  void finish() const;

  bool empty() const { return levels_.empty(); }

  // One of translate, rotate and scale, whose name was just taken.
  Eigen::Affine3d read_step(const BobWord& word);

  // Scene coordinates from the coordinates as written.
  const Eigen::Affine3d& scene_from_written() const;

  // The factor by which lengths grow, nothing where they grow differently in different directions.
  std::optional<double> length_factor() const;

 private:
  struct Level {
    Eigen::Affine3d scene_from_written;
    BobWord opened;
  };

  BobWords& words_;
  BobNumbers& numbers_;
  std::vector<Level> levels_;
};

}  // namespace aspect
