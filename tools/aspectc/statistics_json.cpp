#include "tools/aspectc/statistics_json.h"

#include <nlohmann/json.hpp>

namespace aspect {

std::string statistics_json(const CompileStatistics& s) {
  const nlohmann::ordered_json json = {{"object", s.object},
                                       {"level", s.level},
                                       {"threshold", s.threshold},
                                       {"cluster_threshold", s.cluster_threshold},
                                       {"triangles", s.triangles},
                                       {"views", s.views},
                                       {"views_rendered", s.views_rendered},
                                       {"match_calls", s.match_calls},
                                       {"matches_executed", s.matches_executed},
                                       {"matches_gave_up", s.matches_gave_up},
                                       {"clusters", s.clusters},
                                       {"area_fraction", s.area_fraction},
                                       {"clusters_in_index", s.clusters_in_index},
                                       {"area_fraction_in_index", s.area_fraction_in_index},
                                       {"symmetries", s.symmetries},
                                       {"symmetry_axes", s.symmetry_axes},
                                       {"symmetry_views", s.symmetry_views},
                                       {"contour_types", s.contour_types},
                                       {"key_views", s.key_views},
                                       {"key_view_spacing_deg", s.key_view_spacing_deg},
                                       {"index_bytes", s.index_bytes},
                                       {"threads", s.threads},
                                       {"seconds",
                                        {{"total", s.seconds.total},
                                         {"render", s.seconds.render},
                                         {"features", s.seconds.features},
                                         {"match", s.seconds.match},
                                         {"cluster", s.seconds.cluster},
                                         {"symmetry", s.seconds.symmetry},
                                         {"types", s.seconds.types},
                                         {"emit", s.seconds.emit}}}};
  return json.dump(2) + "\n";
}

}  // namespace aspect
