#include "tools/eval/recall_svg.h"

#include <fmt/format.h>

#include <algorithm>

#include "tools/eval/wilson_interval.h"
#include "tools/plot/svg_plot.h"

namespace aspect {
namespace {

constexpr double kMostHidden = 100 * kHiddenRanges.back().to;

// Beside each other where they are of one height.
double shift_percent(std::size_t series) {
  return 0.9 * static_cast<double>(series % 7);
}

void draw_curve(SvgPage& page, PlotPanel& panel, const ObjectClutter& object, std::size_t series) {
  std::vector<PlotPoint> middles;
  for (std::size_t k = 0; k < kHiddenRanges.size(); ++k) {
    const Recall& recall = object.by_hidden[k];
    if (recall.frames == 0) continue;
    const Share share = share_of(recall.found, recall.frames);
    const double hidden =
        50 * (kHiddenRanges[k].from + kHiddenRanges[k].to) + shift_percent(series);
    page.line(panel.at(hidden, 100 * share.low), panel.at(hidden, 100 * share.high),
              {series_colour(series), 1.5});
    middles.push_back({hidden, 100 * share.share});
  }
  panel.curve(middles, series, true);
}

std::vector<PlotTick> range_ticks() {
  std::vector<PlotTick> ticks = {{0, "0"}};
  for (const HiddenRange& range : kHiddenRanges)
    ticks.push_back({100 * range.to, fmt::format("{:.0f}", 100 * range.to)});
  return ticks;
}

}  // namespace

std::string recall_svg(const ClutterEvaluation& evaluation) {
  std::vector<std::string> names;
  for (const ObjectClutter& object : evaluation.objects) names.push_back(object.object);
  const PlotBox box{kAxisLeft_px + 12, 60, 440, 380};
  const double legend = box.right() + 20;
  SvgPage page(
      legend + std::max(legend_width_px(names), 140.0) + 16,
      std::max(box.bottom() + kAxisBelow_px,
               box.top + 40 + kLegendLine_px * static_cast<double>(names.size())),
      fmt::format("Found in clutter, {} frames in clutter an object", evaluation.settings.views));
  PlotPanel panel(page, box,
                  {"share of the object that is hidden, %", 0, kMostHidden, false, range_ticks()},
                  {"frames in which it is found, %", 0, 100});
  for (std::size_t k = 0; k < evaluation.objects.size(); ++k)
    draw_curve(page, panel, evaluation.objects[k], k);
  page.legend({legend, box.top}, names);
  page.text({legend, box.top + kLegendLine_px * static_cast<double>(names.size()) + 22},
            "upright: 95 % interval", {PlotAnchor::start, 12, "#555555"});
  return page.document();
}

}  // namespace aspect
