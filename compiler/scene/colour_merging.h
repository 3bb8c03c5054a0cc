// Few colours for a mesh that has many: one that was scanned, shaded or covered with pictures.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "compiler/scene/coloured_mesh.h"

namespace aspect {

struct WeighedColour {
  Eigen::Vector3d colour{0, 0, 0};
  double weight = 0;  // such as the area that has it
};

struct ColourClusters {
  std::vector<Eigen::Vector3d> colours;  // by weight, the heaviest first
  std::vector<double> shares;            // of the weight, together 1
  std::vector<std::size_t> cluster_of;   // by colour that was given
};

// At most `count` (at least 1) colours that stand for all: k-means (Lloyd, "Least squares
// quantization in PCM", 1982), by weight. What counts is first the ratio r : g : b, as it does to
// the segmentation, so that the shades of one paint stay together, and brightness less. Each
// cluster's colour is the mean of its own. The same input gives the same output.
// O(colours * count * rounds), at most 100 rounds.
ColourClusters cluster_colours(std::span<const WeighedColour> colours, std::size_t count);

// The colours of a mesh by area, equal ones once; and a mesh of them, near ones made one where they
// are more than a few thousand.
struct MeshColourCount {
  std::vector<WeighedColour> colours;
  std::vector<std::size_t> colour_of;  // by triangle
};
MeshColourCount count_colours(const ColouredMesh& mesh);

// Repaints the faces with `count` colours at most.
void merge_colours(ColouredMesh& mesh, std::size_t count);

}  // namespace aspect
