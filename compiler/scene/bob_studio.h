// The statements around the object: studio, light and surface.
#pragma once

#include "compiler/scene/bob_block.h"
#include "compiler/scene/bob_numbers.h"
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
  BobStudioReader(BobWords& words, BobNumbers& numbers, BobWarnings& warnings)
      : words_(words), numbers_(numbers), warnings_(warnings) {}

  BobStudio studio(const BobWord& statement);
  PointLight light(const BobWord& statement);
  Surface surface(const BobWord& statement);

 private:
  BobBlock block(const BobWord& statement) { return {words_, numbers_, warnings_, statement}; }
  void add_fields_without_effect(BobBlock& fields);
  void read_resolution(const BobWord& word, Studio& studio);
  // The one word behind `field` that is supported, of those the format knows.
  void only_word(const BobWord& field, std::string_view supported,
                 std::span<const std::string_view> known);
  void warn_without_effect(const BobWord& word);

  BobWords& words_;
  BobNumbers& numbers_;
  BobWarnings& warnings_;
};

}  // namespace aspect
