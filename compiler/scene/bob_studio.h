// The statements around the object: studio and light.
#pragma once

#include "compiler/scene/bob_block.h"
#include "compiler/scene/bob_numbers.h"
#include "compiler/scene/bob_transforms.h"
#include "compiler/scene/bob_words.h"
#include "compiler/scene/scene.h"

namespace aspect {

struct BobStudio {
  Studio studio;
  bool shadows = true;
};

// Each reads its statement's braces. Throws BobError.
class BobStudioReader {
 public:
  BobStudioReader(BobWords& words, BobNumbers& numbers, BobWarnings& warnings,
                  const BobTransforms& transforms)
      : words_(words), numbers_(numbers), warnings_(warnings), transforms_(transforms) {}

  BobStudio studio(const BobWord& statement);
  // In scene coordinates.
  Light light(const BobWord& statement);

 private:
  BobBlock block(const BobWord& statement) { return {words_, numbers_, warnings_, statement}; }
  void add_optics(BobBlock& fields, Studio& studio);
  void read_resolution(const BobWord& word, Studio& studio);
  void read_projection(Studio& studio);
  void check_view(const BobBlock& fields, Studio& studio, const BobWord& statement) const;
  void check_light_type(const BobBlock& fields, const Light& light, const BobWord& statement);
  void place(Light& light, const BobWord& statement) const;

  BobWords& words_;
  BobNumbers& numbers_;
  BobWarnings& warnings_;
  const BobTransforms& transforms_;
};

}  // namespace aspect
