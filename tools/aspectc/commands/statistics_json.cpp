#include "tools/aspectc/commands/statistics_json.h"

#include <nlohmann/json.hpp>

namespace aspect {

namespace {

nlohmann::ordered_json json_of(const CompileStatistics& s) {
  return {{"object", s.object},
          {"level", s.level},
          {"threshold", s.threshold},
          {"cluster_threshold", s.cluster_threshold},
          {"triangles", s.triangles},
          {"views", s.views},
          {"border_views", s.border_views},
          {"views_rendered", s.views_rendered},
          {"match_calls", s.match_calls},
          {"matches_executed", s.matches_executed},
          {"matches_gave_up", s.matches_gave_up},
          {"clusters", s.clusters},
          {"area_fraction", s.area_fraction},
          {"clusters_in_index", s.clusters_in_index},
          {"area_fraction_in_index", s.area_fraction_in_index},
          {"area_assigned", s.area_assigned},
          {"area_assigned_in_index", s.area_assigned_in_index},
          {"symmetries", s.symmetries},
          {"symmetry_axes", s.symmetry_axes},
          {"symmetry_views", s.symmetry_views},
          {"contour_types", s.contour_types},
          {"key_views", s.key_views},
          {"key_view_spacing_deg", s.key_view_spacing_deg},
          {"index_bytes", s.index_bytes},
          {"golden_frame_bytes", s.golden_frame_bytes},
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
}

}  // namespace

std::string statistics_json(const std::vector<CompileStatistics>& all, bool as_list) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const CompileStatistics& one : all) list.push_back(json_of(one));
  return (as_list || list.empty() ? list : list.front()).dump(2) + "\n";
}

}  // namespace aspect
