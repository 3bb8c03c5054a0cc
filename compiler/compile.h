// The offline compiler: a scene in, a class index out.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compiler/aspects/compile_options.h"
#include "compiler/aspects/subdivision.h"
#include "compiler/scene/scene.h"
#include "runtime/base/result.h"

namespace aspect {

// Where the time went, in seconds; render, features and match are summed over threads.
struct CompileSeconds {
  double total = 0, render = 0, features = 0, match = 0, cluster = 0, symmetry = 0, types = 0,
         emit = 0;
};

struct CompileStatistics {
  std::string object;
  SensorKind sensor = SensorKind::colour;
  int level = 0;
  double threshold = 0, cluster_threshold = 0;
  std::size_t triangles = 0;     // patches of the viewing sphere at completion
  std::size_t views = 0;         // at their corners
  std::size_t border_views = 0;  // on edges between aspects
  std::size_t views_rendered = 0, match_calls = 0, matches_executed = 0, matches_gave_up = 0;
  std::size_t clusters = 0, clusters_in_index = 0, key_views = 0, contour_types = 0;
  std::size_t symmetries = 0, symmetry_axes = 0;         // without the identity; round axes
  std::size_t symmetry_views = 0;                        // rendered to find them
  double area_fraction = 0, area_fraction_in_index = 0;  // in uniform patches, as in the thesis
  double area_assigned = 0, area_assigned_in_index = 0;  // and in divided ones
  double key_view_spacing_deg = 0;
  std::size_t index_bytes = 0;
  std::size_t golden_frame_bytes = 0;  // of those; 0: there is none
  int threads = 0;
  CompileSeconds seconds;
};

struct CompiledIndex {
  std::vector<std::uint8_t> bytes;
  CompileStatistics statistics;
};

// The whole compiler on one page: renders, subdivides, clusters, names, types, describes, writes.
// With a store path the work so far is kept there and taken up again. The same scene and options
// give the same bytes, for any number of threads and with or without a store.
Result<CompiledIndex> compile(const Scene& scene, const CompileOptions& options,
                              const std::optional<std::filesystem::path>& store_path,
                              const ShowProgress& show_progress, const std::atomic<bool>* stop);

}  // namespace aspect
