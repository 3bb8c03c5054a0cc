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
  // Below the store's: the model as it was when that level was complete. It has no views on edges
  // then, of which the store has the last level's alone.
  std::optional<int> level;
  bool border_views = true;    // false: without views on edges, as in the thesis
  int jobs = 0;                // threads; 0: as many as there are cores. Changes no result
  ShowProgress show_progress;  // may be empty
  const std::atomic<bool>* stop = nullptr;
};

struct StoredModel {
  Recipe recipe;  // its options with the level above
  Renderer renderer;
  Subdivision subdivision;
  std::vector<Cluster> clusters;  // the index's classes in its order, and those that it leaves out
  SphereClasses sphere_classes;
  std::vector<TypeAttributes> types;
  std::vector<ClassDescription> classes;  // one a cluster
};

// `recipe` is the store's. Renders nothing and leaves the store as it is, as long as it is
// complete; views that it has lost are made again and added. The same classes and types as
// compile() finds. Errors name the store.
Result<StoredModel> open_stored_model(const std::filesystem::path& store, Recipe recipe,
                                      const StoredModelSettings& settings);

}  // namespace aspect
