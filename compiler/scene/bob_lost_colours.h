// Colours that a Bob scene names and that are not there.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "compiler/scene/bob_words.h"
#include "compiler/scene/missing_colour.h"

namespace aspect {

class BobLostColours {
 public:
  // Without a colour to stand for them they are errors.
  BobLostColours(const std::optional<Eigen::Vector3d>& stand_in,
                 std::vector<MissingColour>& missing)
      : stand_in_(stand_in), missing_(missing) {}

  // The colour that stands for what `word` names; noted once. Throws BobError where there is none.
  Eigen::Vector3d stand_in(const BobWords& words, const BobWord& word, std::string what,
                           std::string cure);

 private:
  const std::optional<Eigen::Vector3d> stand_in_;
  std::vector<MissingColour>& missing_;
};

}  // namespace aspect
