// Models of compiler/models on their way through the compiler, for tests of its stages.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compiler/aspects/clusters.h"
#include "compiler/compile.h"
#include "compiler/scene/scene.h"

namespace aspect {

std::filesystem::path model_file(const std::string& name);

// Fails the program where the model cannot be read.
Scene model_scene(const std::string& name);

// The same in small pictures, where a test is about the order of the work and not about what is
// seen: a view takes a tenth of the time.
Scene small_model_scene(const std::string& name);

CompileOptions options_of_level(int level);

struct CompiledModel {
  Scene scene;
  CompileOptions options;
  Subdivision subdivision;
  std::vector<Cluster> clusters;
};

// Made at the first call, then kept for the other tests of the program.
const CompiledModel& compiled_model(const std::string& name, int level);

// The index of a scene, without a store. Fails the program where there is none.
std::vector<std::uint8_t> index_bytes_of(const Scene& scene, const CompileOptions& options);

inline std::size_t place_of(VertexId vertex) {
  return static_cast<std::size_t>(vertex);
}
inline std::size_t place_of(PatchId patch) {
  return static_cast<std::size_t>(patch);
}

// The surface that a contour shows most of.
std::uint16_t main_surface(const ObservedContour& contour);

}  // namespace aspect
