// What an index is made of, before its budget is known.
#pragma once

#include <cstdint>
#include <span>

#include "compiler/aspects/border_classes.h"
#include "compiler/aspects/symmetry.h"
#include "compiler/index/class_model.h"
#include "compiler/index/object_facets.h"
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
  PackedModel model{};
};

}  // namespace aspect
