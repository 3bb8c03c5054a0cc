#include "compiler/scene/step_mesh.h"

#include <dlfcn.h>

#include <fmt/format.h>

namespace aspect {
namespace {

// Beside the program, or where a package has it; empty: there is none.
std::filesystem::path module_file() {
  std::error_code unknown;
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path();
  for (const char* place : {".", "../lib/aspect"})
    if (std::filesystem::path file = folder / place / kStepModule;
        std::filesystem::exists(file, unknown))
      return file;
  return {};
}

}  // namespace

ColouredMesh read_step(const std::filesystem::path& file, const StepReading& reading) {
  const std::filesystem::path module = module_file();
  if (module.empty())
    throw MeshError(
        "this build reads no STEP; install libocct-data-exchange-dev (tools/setup.sh build) and "
        "build again, or export a mesh with colours");
  void* loaded = ::dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* found = loaded == nullptr ? nullptr : ::dlsym(loaded, kReadStepFile);
  if (found == nullptr) {
    const char* fault = ::dlerror();
    throw MeshError(fmt::format("{} cannot be loaded ({}); build again", module.string(),
                                fault == nullptr ? "unknown" : fault));
  }
  ColouredMesh mesh;
  reinterpret_cast<ReadStepFile>(found)(file.c_str(), reading, mesh);
  return mesh;
}

}  // namespace aspect
