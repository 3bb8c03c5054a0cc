// From words to a scene: the statements in their order.
#pragma once

#include <optional>
#include <vector>

#include "compiler/scene/bob_block.h"
#include "compiler/scene/bob_numbers.h"
#include "compiler/scene/bob_shapes.h"
#include "compiler/scene/bob_studio.h"
#include "compiler/scene/bob_surface.h"
#include "compiler/scene/bob_transforms.h"
#include "compiler/scene/bob_words.h"
#include "compiler/scene/scene.h"

namespace aspect {

// For one scene. Throws BobError.
class BobParser {
 public:
  // A picture keeps a primitive's number + 1 in 16 bits, with 0 for the background.
  static constexpr std::size_t kMaxPrimitives = 65534;
  static constexpr std::size_t kMaxLights = 256;

  BobParser(BobWords& words, const std::optional<Eigen::Vector3d>& missing_colour);

  // All but the scene's name.
  Scene parse();

 private:
  void statement(const BobWord& word);
  [[noreturn]] void unknown_statement(const BobWord& word) const;
  void studio(const BobWord& word);
  void light(const BobWord& word);
  void primitive(const BobWord& word, BobShapes::Shape shape);
  void warn_where_it_leaves_the_picture();

  BobWords& words_;
  Scene scene_;
  BobWarnings warnings_;
  BobLostColours lost_;
  BobNumbers numbers_;
  BobTransforms transforms_;
  BobShapes shapes_;
  BobStudioReader studio_reader_;
  BobSurfaceReader surface_reader_;
  Surface surface_;  // of the primitives that follow
  bool surface_is_listed_ = false;
  bool shadows_ = true;
  std::optional<BobWord> studio_word_;
  std::vector<BobWord> primitive_words_;
};

}  // namespace aspect
