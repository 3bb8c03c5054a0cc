// Which colours of an object are common in its surroundings, and what to paint them.
#pragma once

#include "compiler/aspects/colour_separation.h"
#include "tools/eval/background_pictures.h"
#include "tools/explain/background_colours.h"
#include "tools/explain/colour_cure.h"

namespace aspect {

// The palette of the cures with how common its colours are in the pictures.
std::vector<PaletteColour> palette_before(const BackgroundPictures& pictures,
                                          const VisionParameters& vision);

// Faces of one r : g : b are one colour; those that are seen as black are none. Of the common ones
// up to three get a colour of the palette that is less common and far from all others. With a
// `palette` of no colours none does. Of more than 64 colours those of most surfaces are told of.
BackgroundColours background_colours(const Faces& faces, const BackgroundPictures& pictures,
                                     std::span<const PaletteColour> palette,
                                     const VisionParameters& vision);

}  // namespace aspect
