// The class index as bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/aspects/border_classes.h"
#include "compiler/aspects/symmetry.h"
#include "compiler/index/class_model.h"
#include "compiler/scene/scene.h"
#include "runtime/recognition/golden_frame.h"

namespace aspect {

struct IndexContents {
  const Scene& scene;
  std::uint64_t scene_hash = 0;
  const CompileOptions& options;
  const Subdivision& subdivision;
  std::span<const Cluster> clusters;
  const SphereClasses& sphere_classes;
  std::span<const ClassDescription> classes;  // one a cluster
  std::span<const TypeAttributes> types;
  Symmetries symmetries{};
  std::span<const GoldenFrame> golden_candidates{};
};

struct WrittenIndex {
  std::vector<std::uint8_t> bytes;
  std::size_t class_count = 0;  // fewer than were found where the budget demands it
  std::size_t key_view_count = 0;
  double area_fraction = 0, area_assigned = 0;  // of the classes kept
  double key_view_spacing_deg = 0;
  std::size_t golden_frame_bytes = 0;  // 0: none
};

// Keeps within options.max_index_bytes: key views are taken farther apart, and where one a class
// is still too much, the smallest classes are left out. One of the golden frame's candidates is
// added where the index answers it rightly: see golden_choice.h; room for it is kept free. The same
// contents give the same bytes.
WrittenIndex write_index(const IndexContents& contents);

}  // namespace aspect
