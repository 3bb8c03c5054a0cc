// The offline compiler: a scene in, a class index out.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compiler/aspects/border_classes.h"
#include "compiler/aspects/clusters.h"
#include "compiler/aspects/compile_options.h"
#include "compiler/aspects/subdivision.h"
#include "compiler/aspects/symmetry.h"
#include "compiler/index/class_model.h"
#include "compiler/index/index_writer.h"
#include "compiler/scene/scene.h"
#include "runtime/base/result.h"

namespace aspect {

// Where the time went after the subdivision.
struct CompileSeconds {
  double total = 0, cluster = 0, symmetry = 0, types = 0, emit = 0;
};

struct CompileStatistics {
  std::string object;
  SensorKind sensor = SensorKind::colour;
  int level = 0;
  double threshold = 0, cluster_threshold = 0;
  int threads = 0;
  SubdivisionStatistics subdivision{};
  ClusterStatistics clusters{};
  std::size_t symmetries = 0, symmetry_axes = 0;  // without the identity; round axes
  std::size_t symmetry_views = 0;                 // rendered to find them
  IndexStatistics index{};
  CompileSeconds seconds{};
};

struct CompiledIndex {
  std::vector<std::uint8_t> bytes;
  CompileStatistics statistics;
};

// An index with all that was learnt on the way to it: what reports show.
struct LearntModel {
  Subdivision subdivision;
  std::vector<Cluster> clusters;
  SphereClasses sphere_classes;
  Symmetries symmetries;
  std::vector<TypeAttributes> types;
  std::vector<ClassDescription> classes;  // one a cluster; the index holds the first of them
  CompiledIndex index;
};

// The whole compiler on one page: renders, subdivides, clusters, names, types, describes, writes.
// With a store path the work so far is kept there and taken up again. The same scene and options
// give the same bytes, for any number of threads and with or without a store.
Result<LearntModel> compile_model(const Scene& scene, const CompileOptions& options,
                                  const std::optional<std::filesystem::path>& store_path,
                                  const ShowProgress& show_progress, const std::atomic<bool>* stop);

// The index alone.
Result<CompiledIndex> compile(const Scene& scene, const CompileOptions& options,
                              const std::optional<std::filesystem::path>& store_path,
                              const ShowProgress& show_progress, const std::atomic<bool>* stop);

}  // namespace aspect
