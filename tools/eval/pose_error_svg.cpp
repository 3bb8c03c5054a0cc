#include "tools/eval/pose_error_svg.h"

#include <fmt/format.h>

#include <algorithm>

#include "tools/plot/svg_plot.h"

namespace aspect {
namespace {

constexpr double kTop_px = 56, kWidth_px = 360, kHeight_px = 230, kGap_px = 30;
constexpr double kTold = 5;  // what the tables count as near

struct ErrorSeries {
  std::vector<double> errors;
  std::size_t views = 0;  // of which some have no error to tell
};

struct ErrorPanel {
  PlotAxis axis;
  std::vector<ErrorSeries> series;  // by object
};

// Of any number of errors some hundred points, the last one among them.
std::vector<PlotPoint> accumulated(ErrorSeries series, double least) {
  constexpr std::size_t kMostPoints = 400;
  std::sort(series.errors.begin(), series.errors.end());
  std::vector<PlotPoint> points;
  const std::size_t count = series.errors.size();
  const auto percent = [&](std::size_t within) {
    return 100.0 * static_cast<double>(within) / static_cast<double>(series.views);
  };
  if (count == 0) return points;
  points.push_back({least, 0});
  for (std::size_t k = 0; k < count; ++k) {
    if (k + 1 < count && k % (count / kMostPoints + 1) != 0) continue;
    points.push_back({series.errors[k], percent(k)});
    points.push_back({series.errors[k], percent(k + 1)});
  }
  return points;
}

void draw(SvgPage& page, const PlotBox& box, const ErrorPanel& errors, const char* what) {
  PlotPanel panel(page, box, errors.axis, {fmt::format("{} within it, %", what), 0, 100});
  page.line(panel.at(kTold, 0), panel.at(kTold, 100), {"#999999", 1, "2 3"});
  for (std::size_t k = 0; k < errors.series.size(); ++k) {
    const ErrorSeries& series = errors.series[k];
    std::vector<PlotPoint> points = accumulated(series, errors.axis.least);
    if (points.empty()) continue;
    points.push_back({errors.axis.most, points.back().y});
    panel.curve(points, k, false);
    // Where the line passes one half, if it does.
    std::vector<double> all = series.errors;
    const std::size_t half = (series.views + 1) / 2;
    if (half == 0 || half > all.size()) continue;
    std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(half - 1), all.end());
    page.mark(panel.at(all[half - 1], 50), k, fmt::format("half within {:.3g}", all[half - 1]));
  }
}

std::string plot_of(const std::vector<ErrorPanel>& panels, const std::vector<std::string>& names,
                    const std::string& title, const char* what) {
  const double step_x = kAxisLeft_px + kWidth_px + kGap_px,
               step_y = kHeight_px + kAxisBelow_px + kGap_px;
  const auto rows = static_cast<double>((panels.size() + 1) / 2);
  const double legend = 2 * step_x - kGap_px + 24;
  const double height = std::max(kTop_px + rows * step_y - kGap_px + 4,
                                 kTop_px + kLegendLine_px * static_cast<double>(names.size()) + 40);
  SvgPage page(legend + std::max(legend_width_px(names), 110.0) + 16, height, title);
  for (std::size_t k = 0; k < panels.size(); ++k)
    draw(page,
         {kAxisLeft_px + static_cast<double>(k % 2) * step_x,
          kTop_px + static_cast<double>(k / 2) * step_y, kWidth_px, kHeight_px},
         panels[k], what);
  page.legend({legend, kTop_px}, names);
  page.text({legend, kTop_px + kLegendLine_px * static_cast<double>(names.size()) + 22},
            "mark: half of all", {PlotAnchor::start, 12, "#555555"});
  return page.document();
}

std::vector<ErrorPanel> pose_panels() {
  return {{{"turn, degrees", 0.01, 180, true}, {}},
          {{"place of its centre, % of the distance", 0.001, 100, true}, {}},
          {{"vertices in the picture, px (root mean square)", 0.01, 1000, true}, {}}};
}

void add(const std::optional<PoseError>& error, ErrorSeries& turn, ErrorSeries& place,
         ErrorSeries& vertices) {
  for (ErrorSeries* series : {&turn, &place, &vertices}) ++series->views;
  if (!error) return;
  turn.errors.push_back(error->rotation_deg);
  place.errors.push_back(error->translation_percent);
  vertices.errors.push_back(error->reprojection_px);
}

}  // namespace

std::string pose_error_svg(const Evaluation& evaluation) {
  ErrorPanel direction{{"direction of the view, degrees", 0.01, 180, true}, {}};
  std::vector<ErrorPanel> poses = pose_panels();
  std::vector<std::string> names;
  for (const ObjectEvaluation& object : evaluation.objects) {
    names.push_back(object.object);
    ErrorSeries view, turn, place, vertices;
    for (const ViewOutcome& outcome : object.outcomes) {
      ++view.views;
      view.errors.push_back(outcome.error_deg);
      add(outcome.pose, turn, place, vertices);
    }
    direction.series.push_back(std::move(view));
    poses[0].series.push_back(std::move(turn));
    poses[1].series.push_back(std::move(place));
    poses[2].series.push_back(std::move(vertices));
  }
  poses.insert(poses.begin(), std::move(direction));
  return plot_of(poses, names,
                 fmt::format("Error of view and pose, {} views an object, modulo its rotations",
                             evaluation.settings.views),
                 "views");
}

std::string pose_error_svg(const ClutterEvaluation& evaluation) {
  std::vector<ErrorPanel> poses = pose_panels();
  std::vector<std::string> names;
  for (const ObjectClutter& object : evaluation.objects) {
    names.push_back(object.object);
    ErrorSeries turn, place, vertices;
    for (const ClutterOutcome& outcome : object.outcomes)
      if (outcome.counts()) add(outcome.pose, turn, place, vertices);
    poses[0].series.push_back(std::move(turn));
    poses[1].series.push_back(std::move(place));
    poses[2].series.push_back(std::move(vertices));
  }
  return plot_of(poses, names, "Error of the pose in clutter, modulo the object's rotations",
                 "frames");
}

}  // namespace aspect
