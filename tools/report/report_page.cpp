#include "tools/report/report_page.h"

#include <fmt/format.h>

#include <map>

#include "tools/report/aspect_figures.h"
#include "tools/report/chart_figures.h"
#include "tools/report/embedded_files.h"
#include "tools/report/report_json.h"
#include "tools/report/report_tables.h"
#include "tools/report/sphere_figures.h"

namespace aspect {
namespace {

std::string summary(const ReportContents& contents) {
  const CompileStatistics& s = contents.model.index.statistics;
  return fmt::format(
      "{} aspects \u00b7 {:.1f} % of the viewing sphere \u00b7 level {} \u00b7 {:.1f} KiB index",
      contents.aspects(), 100 * s.clusters.area_assigned, s.level,
      static_cast<double>(s.index.bytes) / 1024);
}

std::string halves(const ReportContents& contents) {
  SphereMarks marks;
  marks.tried_views = marks.blind_spots = true;
  std::string html;
  for (const HalfSphereView& half : contents.halves)
    html += inline_svg(half_figure(contents, half, marks));
  return html;
}

// What is between {{ and }} stands for a text. What is put in is not looked at again.
std::string filled(std::string_view page, const std::map<std::string_view, std::string>& texts) {
  std::string html;
  for (;;) {
    const std::size_t open = page.find("{{"), close = page.find("}}", open);
    if (open == std::string_view::npos || close == std::string_view::npos) break;
    html += page.substr(0, open);
    html += texts.at(page.substr(open + 2, close - open - 2));
    page.remove_prefix(close + 2);
  }
  return html.append(page);
}

}  // namespace

std::string report_page(const ReportContents& contents) {
  const Explanation& explanation = contents.explanation;
  return filled(kReportPage, {{"title", escaped(contents.model.index.statistics.object)},
                              {"style", std::string(kReportStyle)},
                              {"summary", escaped(summary(contents))},
                              {"halves", halves(contents)},
                              {"graph_key", inline_svg(graph_key_figure())},
                              {"coverage_figure", inline_svg(coverage_figure(contents))},
                              {"areas_figure", inline_svg(areas_figure(contents))},
                              {"coverage_table", coverage_table(contents)},
                              {"confusion_figure", inline_svg(confusion_figure(contents))},
                              {"accuracy", accuracy_list(explanation)},
                              {"confusions", confusion_list(contents)},
                              {"blind_spots", blind_spot_list(explanation)},
                              {"cures", cure_list(explanation)},
                              {"symmetries", symmetry_list(contents)},
                              {"budget", budget_list(contents)},
                              {"statistics", statistics_list(contents)},
                              {"numbers", report_json(contents)},
                              {"turntable", std::string(kTurntableScript)},
                              {"script", std::string(kReportScript)}});
}

std::vector<std::pair<std::string, std::string>> report_figures(const ReportContents& contents) {
  SphereMarks none, patches, tried;
  patches.patches = true;
  tried.tried_views = tried.blind_spots = true;
  std::vector<std::pair<std::string, std::string>> files = {
      {"object.svg", svg_file(overview_figure(contents))},
      {"sphere.svg", svg_file(sphere_figure(contents, none))},
      {"sphere_patches.svg", svg_file(sphere_figure(contents, patches))},
      {"sphere_tried_views.svg", svg_file(sphere_figure(contents, tried))},
      {"coverage.svg", svg_file(coverage_figure(contents))},
      {"areas.svg", svg_file(areas_figure(contents))},
      {"confusions.svg", svg_file(confusion_figure(contents))}};
  for (std::size_t k = 0; k < contents.aspects(); ++k)
    files.emplace_back(fmt::format("aspect_{:03}.svg", k), svg_file(aspect_figure(contents, k)));
  return files;
}

}  // namespace aspect
