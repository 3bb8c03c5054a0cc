// Everything that decides what an index becomes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "compiler/matching/graph_match.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

enum class Scoring : std::uint8_t { none, views, area };

struct CompileOptions {
  // Patches are split without question up to min_level, and never beyond level (thesis 3.3.2).
  int min_level = 3;
  int level = 5;

  // Largest match cost at which the three views of a patch count as alike, in units of kCostUnit =
  // 10000; the second one holds when patches are clustered and must not be smaller. Higher: fewer,
  // larger patches and clusters, until different aspects merge.
  double threshold = 10000;
  double cluster_threshold = 100000;

  // Clusters that cover less of the sphere than this are discarded as noise along the borders,
  // as the thesis does with its smallest (4.3.1).
  double small_cluster_fraction = 4e-4;

  // Levels end where this share of the sphere is in uniform patches (thesis 3.3.2); 1: never.
  double stop_area = 1;

  // Most views that are spent on dividing patches that straddle a border along it; 0: they are
  // left out, as in the thesis. Objects of some ten surfaces need 10,000 to 40,000 at level 6.
  int border_views = 40000;

  // Search time of one match, 0: any. What is cut short by it depends on the machine.
  double match_limit_ms = 0;

  int contour_types = 60;  // K of the k-means, at most kMaxTypes
  Scoring scoring = Scoring::views;
  MatchScales match_scales;
  VisionParameters vision;
  std::size_t max_index_bytes = 100 * 1024;

  int jobs = 0;  // threads; 0: as many as there are cores

  // The options that change a view or a match, in words: part of a store's key.
  std::string store_key() const;

  MatchLimits match_limits() const;
};

}  // namespace aspect
