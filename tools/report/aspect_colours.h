// Colours of aspects, as on a map of countries.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tools/report/aspect_neighbours.h"

namespace aspect {

// "#8dd3c7" and so on. Light enough for black letters, told apart in print.
inline constexpr std::array<const char*, 12> kMapColours = {
    "#7fc8f8", "#ffb870", "#9ddb8a", "#f59aa8", "#c7b2f0", "#f5e06e",
    "#73d6c4", "#e2a3dc", "#cfd98a", "#a8b8d8", "#f3c3a2", "#8fd0e0"};
inline constexpr const char* kNoAspectColour = "#d5d9df";

// By aspect: its place in kMapColours. Neighbours differ as long as colours are left, and the
// colours are used about equally. O(borders).
std::vector<std::size_t> map_colours(const std::vector<std::vector<AspectNeighbour>>& neighbours);

}  // namespace aspect
