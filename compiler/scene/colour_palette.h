// Colours told apart only where they differ by more than a tolerance.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace aspect {

class ColourPalette {
 public:
  // The largest difference of a channel between a colour and the one that stands for it.
  explicit ColourPalette(double tolerance) : tolerance_(tolerance) {}

  // The index of the earliest colour that is near, or of the colour itself, added.
  std::size_t find_or_add(const Eigen::Vector3d& colour);

  const std::vector<Eigen::Vector3d>& colours() const { return colours_; }

 private:
  double tolerance_;
  std::vector<Eigen::Vector3d> colours_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;  // a tolerance wide
};

}  // namespace aspect
