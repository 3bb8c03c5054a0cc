#include "tools/report/aspect_colours.h"

namespace aspect {

std::vector<std::size_t> map_colours(const std::vector<std::vector<AspectNeighbour>>& neighbours) {
  constexpr std::size_t kCount = kMapColours.size();
  std::vector<std::size_t> colours(neighbours.size(), kCount);
  for (std::size_t aspect = 0; aspect < neighbours.size(); ++aspect) {
    std::array<bool, kCount> taken{};
    for (const AspectNeighbour& neighbour : neighbours[aspect]) {
      const std::size_t colour = colours[static_cast<std::size_t>(neighbour.aspect)];
      if (colour < kCount) taken[colour] = true;
    }
    // Each begins its search at another colour.
    std::size_t colour = aspect % kCount;
    for (std::size_t k = 0; k < kCount && taken[colour]; ++k) colour = (colour + 1) % kCount;
    colours[aspect] = colour;
  }
  return colours;
}

}  // namespace aspect
