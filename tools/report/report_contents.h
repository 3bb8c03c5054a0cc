// All that a report shows of a compiled model, before it is drawn.
#pragma once

#include <string>
#include <vector>

#include "compiler/aspects/level_coverage.h"
#include "compiler/compile.h"
#include "compiler/recipe.h"
#include "compiler/render/renderer.h"
#include "compiler/store/store.h"
#include "tools/explain/explanation.h"
#include "tools/report/aspect_neighbours.h"
#include "tools/report/aspect_views.h"
#include "tools/report/object_axes.h"
#include "tools/report/sphere_outlines.h"
#include "tools/report/thesis_rows.h"

namespace aspect {

// One of the thesis's six: half of the sphere, and the object from its middle.
struct HalfSphereView {
  std::string name;  // "z >= 0"
  LookFrame frame;
  SeenView picture;
};

// What an index of this model takes where it may take anything.
struct IndexWithoutBudget {
  std::size_t bytes = 0, key_views = 0;
};

struct ReportContents {
  Recipe recipe;
  StoreContents store;
  std::uintmax_t store_bytes = 0;
  LearntModel model;
  Explanation explanation;
  std::vector<LevelCoverage> levels;
  std::vector<ThesisRow> thesis;  // empty where the object is none of the thesis's
  IndexWithoutBudget without_budget;
  Studio studio;  // the scene's, its up an axis where it is near one
  SphereMesh mesh;
  std::vector<HalfSphereView> halves;
  HalfSphereView overview;                               // from the front, above and beside
  std::vector<double> areas;                             // by aspect, share of the sphere
  std::vector<std::vector<AspectNeighbour>> neighbours;  // by aspect
  std::vector<std::size_t> colours;                      // by aspect, into kMapColours
  std::vector<std::vector<SeenView>> views;              // by aspect
  std::vector<ObjectAxis> axes;

  std::size_t aspects() const { return model.clusters.size(); }
  bool is_in_index(std::size_t aspect) const {
    return aspect < model.index.statistics.index.classes;
  }
};

struct ReportSettings {
  std::filesystem::path scene;  // empty: the store's
  ExplainSettings trials;
};

// Makes the store's model again, which renders nothing new for it, puts it to the test and gathers
// what there is to see.
Result<ReportContents> gather(const std::filesystem::path& store, const ReportSettings& settings);

// A to Z, AA and so on.
std::string contour_letters(std::size_t name);

}  // namespace aspect
