#include "compiler/scene/colour_palette.h"

#include <algorithm>
#include <cmath>

namespace aspect {
namespace {

std::uint64_t cell_of(double r, double g, double b) {
  const auto index = [](double value) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(value)) & 0xfffffu;
  };
  return index(r) << 40 | index(g) << 20 | index(b);
}

}  // namespace

std::size_t ColourPalette::find_or_add(const Eigen::Vector3d& colour) {
  const Eigen::Vector3d cell = (colour / tolerance_).array().floor();
  std::size_t found = colours_.size();
  for (int k = 0; k < 27; ++k) {
    const auto near =
        cells_.find(cell_of(cell[0] + k % 3 - 1, cell[1] + k / 3 % 3 - 1, cell[2] + k / 9 - 1));
    if (near == cells_.end()) continue;
    for (const std::size_t index : near->second)
      if ((colours_[index] - colour).cwiseAbs().maxCoeff() <= tolerance_)
        found = std::min(found, index);
  }
  if (found < colours_.size()) return found;
  cells_[cell_of(cell[0], cell[1], cell[2])].push_back(found);
  colours_.push_back(colour);
  return found;
}

}  // namespace aspect
