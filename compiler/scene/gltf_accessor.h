// The numbers of a glTF file.
#pragma once

#include <string_view>
#include <vector>

#include "compiler/scene/gltf_file.h"

namespace aspect {

struct GltfNumbers {
  std::size_t count = 0, width = 0;  // elements, and numbers of each
  std::vector<double> values;        // element by element

  double at(std::size_t element, std::size_t k) const { return values[element * width + k]; }
};

// Of any component type, strided, sparse, and normalised where the accessor says so. `what` names
// it in messages. Throws MeshError where it is larger than what it reads, or has more than `most`
// elements.
GltfNumbers read_accessor(GltfFile& gltf, std::size_t index, std::string_view what,
                          std::size_t most);

}  // namespace aspect
