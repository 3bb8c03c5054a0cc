// All that write_index needs, made from a compiled model.
#pragma once

#include <vector>

#include "compiler/index/class_model.h"
#include "compiler/index/contour_types.h"
#include "compiler/index/index_writer.h"
#include "tests/compiler/aspects/compiled_model.h"

namespace aspect {

struct DescribedModel {
  const CompiledModel& model;
  CompileOptions options;
  std::vector<Cluster> clusters;
  SphereClasses sphere_classes;
  std::vector<TypeAttributes> types;
  std::vector<ClassDescription> classes;

  static constexpr std::uint64_t kSceneHash = 0x0123456789ABCDEF;
  IndexContents contents() const {
    return {model.scene, kSceneHash,     options, model.subdivision,
            clusters,    sphere_classes, classes, types};
  }
};

inline DescribedModel described_model(const std::string& name, int level,
                                      Scoring scoring = Scoring::views) {
  const CompiledModel& model = compiled_model(name, level);
  DescribedModel described{model, model.options, model.clusters, {}, {}, {}};
  described.sphere_classes = divide_borders(model.subdivision, model.options, described.clusters);
  described.options.scoring = scoring;
  described.types = find_contour_types(contour_samples(model.subdivision, described.clusters),
                                       static_cast<std::size_t>(model.options.contour_types));
  for (const Cluster& cluster : described.clusters)
    described.classes.push_back(
        describe_class(model.subdivision, cluster, described.types, scoring));
  return described;
}

}  // namespace aspect
