#include "tools/aspectc/commands/statistics_json.h"

#include <nlohmann/json.hpp>

namespace aspect {

namespace {

double seconds(std::chrono::nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

nlohmann::ordered_json json_of(const CompileStatistics& s) {
  return {{"object", s.object},
          {"level", s.level},
          {"threshold", s.threshold},
          {"cluster_threshold", s.cluster_threshold},
          {"triangles", s.subdivision.patches},
          {"views", s.subdivision.views},
          {"border_views", s.subdivision.border_views},
          {"views_rendered", s.subdivision.views_rendered},
          {"match_calls", s.subdivision.match_calls},
          {"matches_executed", s.subdivision.matches_executed},
          {"matches_gave_up", s.subdivision.matches_gave_up},
          {"clusters", s.clusters.clusters},
          {"area_fraction", s.clusters.area_fraction},
          {"clusters_in_index", s.index.classes},
          {"area_fraction_in_index", s.index.area_fraction},
          {"area_assigned", s.clusters.area_assigned},
          {"area_assigned_in_index", s.index.area_assigned},
          {"symmetries", s.symmetries},
          {"symmetry_axes", s.symmetry_axes},
          {"symmetry_views", s.symmetry_views},
          {"contour_types", s.index.contour_types},
          {"key_views", s.index.key_views},
          {"key_view_spacing_deg", s.index.key_view_spacing_deg},
          {"index_bytes", s.index.bytes},
          {"golden_frame_bytes", s.index.golden_frame_bytes},
          {"threads", s.threads},
          {"seconds",
           {{"total", s.seconds.total},
            {"render", seconds(s.subdivision.render_time)},
            {"features", seconds(s.subdivision.feature_time)},
            {"match", seconds(s.subdivision.match_time)},
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
