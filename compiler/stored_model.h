// The model that a store holds, whole: what the compiler has before it chooses what an index keeps.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <vector>

#include "compiler/aspects/border_classes.h"
#include "compiler/aspects/clusters.h"
#include "compiler/aspects/subdivision.h"
#include "compiler/index/class_model.h"
#include "compiler/recipe.h"

namespace aspect {

struct StoredModelSettings {
  // Below the store's: the model as it was when that level was complete, without views on edges,
  // as in the thesis.
  std::optional<int> level;
  std::optional<Scene> scene;  // where the store's cannot be read again
  int jobs = 0;                // threads; 0: as many as there are cores. Changes no result
  ShowProgress show_progress;  // may be empty
  const std::atomic<bool>* stop = nullptr;
};

struct StoredModel {
  Recipe recipe;  // its options with the level above
  Renderer renderer;
  Subdivision subdivision;
  std::vector<Cluster>
      clusters;  // the classes of the index, in its order, and those left out of it
  SphereClasses sphere_classes;
  std::vector<TypeAttributes> types;
  std::vector<ClassDescription> classes;  // one a cluster
};

// Renders nothing and leaves the store as it is, as long as it is complete; views that it has lost
// are made again and added. The same classes and types as compile() finds. Errors name the store.
Result<StoredModel> open_stored_model(const std::filesystem::path& store,
                                      const StoredModelSettings& settings);

}  // namespace aspect
