// The statement `surface` and the texture inside it.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "compiler/scene/bob_block.h"
#include "compiler/scene/bob_numbers.h"
#include "compiler/scene/bob_transforms.h"
#include "compiler/scene/bob_words.h"
#include "compiler/scene/scene.h"

namespace aspect {

// Reads the statement's braces. Throws BobError.
//
// surface { ... shine P [C] ... texture { ... } }: a highlight without a colour of its own has the
// mirror's, as in Vivid, and is white where there is no mirror.
// texture { checker [A B] | map "file.png"  scale .. translate .. rotate .. }: the steps move the
// pattern, in the order written. A texture stands in the transform around its surface statement.
class BobSurfaceReader {
 public:
  // Of all maps of a scene: 48 MB of memory.
  static constexpr std::size_t kMaxMapPixels = std::size_t{16} << 20;

  BobSurfaceReader(BobWords& words, BobNumbers& numbers, BobWarnings& warnings,
                   BobLostColours& lost, BobTransforms& transforms)
      : words_(words),
        numbers_(numbers),
        warnings_(warnings),
        lost_(lost),
        transforms_(transforms) {}

  Surface read(const BobWord& statement);

 private:
  BobBlock block(const BobWord& statement) { return {words_, numbers_, warnings_, statement}; }
  void read_shine(const BobWord& word, Surface& surface, bool& is_colored);
  std::shared_ptr<const Texture> read_texture(const BobWord& statement);
  Checker read_checker(const BobWord& word);
  ImageMap read_map(const BobWord& word);
  ImageMap lost_map(const BobWord& word, const std::filesystem::path& path,
                    const std::string& fault);
  bool color_follows() const;

  BobWords& words_;
  BobNumbers& numbers_;
  BobWarnings& warnings_;
  BobLostColours& lost_;
  BobTransforms& transforms_;
  std::optional<Eigen::Vector3d> stand_in_;  // of the surface's map, where that is not found
  std::map<std::string, std::shared_ptr<const TextureMap>> maps_;  // by path
  std::size_t map_pixels_ = 0;
};

}  // namespace aspect
