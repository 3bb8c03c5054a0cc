// Which colours to change so that faces are not mistaken any more, and whether that helps.
#pragma once

#include <span>

#include "tools/explain/trials.h"

namespace aspect {

// Hues at full and at half strength, and grey; none of them dark.
std::vector<PaletteColour> palette();

// What to paint the one of the colours in: of the palette a colour that the recogniser takes for
// none of the others, of those one that is as little common in the backgrounds as can be, of
// those the one that is farthest from all others. Nothing where the palette is empty.
std::optional<BetterPaint> best_paint(std::span<const PaletteColour> palette, std::size_t changed,
                                      const std::vector<Eigen::Vector3d>& colours,
                                      const VisionParameters& vision);

// For the faces that are mistaken most, the best paint of the palette.
// Pairs whose colours the segmentation separates well already are left alone: it is not their
// colour that confuses.
std::vector<ColourChange> colour_changes(const std::vector<FaceConfusion>& confusions,
                                         const Faces& faces, const VisionParameters& vision,
                                         std::span<const PaletteColour> palette);

// Compiles the scene with the changes, at a low level and without a store, and runs the same trials
// again.
Result<Cure> try_changes(const Recipe& recipe, const std::vector<ColourChange>& changes,
                         const Faces& faces, const std::vector<Trial>& before,
                         const ExplainSettings& settings);

}  // namespace aspect
