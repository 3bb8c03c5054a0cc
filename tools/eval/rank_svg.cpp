#include "tools/eval/rank_svg.h"

#include <fmt/format.h>

#include <algorithm>

#include "tools/plot/svg_plot.h"

namespace aspect {
namespace {

constexpr double kTop_px = 78, kSide_px = 340, kGap_px = 40;

std::vector<PlotTick> rank_ticks() {
  std::vector<PlotTick> ticks;
  for (int rank = 1; rank <= kPlottedRanks; ++rank)
    ticks.push_back({static_cast<double>(rank), std::to_string(rank)});
  return ticks;
}

PlotPanel panel_at(SvgPage& page, double left, const char* head) {
  page.text({left + kSide_px / 2, kTop_px - 14}, head, {PlotAnchor::middle, 13, "#444444"});
  return {page,
          {left, kTop_px, kSide_px, kSide_px},
          {"n, suggestions looked at", 1, kPlottedRanks, false, rank_ticks()},
          {"views whose right class is among the first n, %", 0, 100}};
}

void draw_ours(PlotPanel& panel, const Evaluation& evaluation, bool with_symmetry) {
  for (std::size_t k = 0; k < evaluation.objects.size(); ++k) {
    std::vector<PlotPoint> points;
    for (int rank = 1; rank <= kPlottedRanks; ++rank)
      points.push_back({static_cast<double>(rank),
                        percent_within(evaluation.objects[k].outcomes, rank, with_symmetry)});
    panel.curve(points, k, true);
  }
}

// Whether there is any.
bool draw_thesis(SvgPage& page, const PlotPanel& panel, const Evaluation& evaluation,
                 const ThesisRanks& thesis) {
  bool any = false;
  for (std::size_t k = 0; k < evaluation.objects.size(); ++k) {
    const auto* ranks = ranks_of(thesis, evaluation.objects[k].object);
    if (ranks == nullptr) continue;
    any = true;
    std::vector<PlotPoint> points;
    for (const RankShare& share : *ranks)
      if (share.rank <= kPlottedRanks) points.push_back(panel.at(share.rank, share.percent));
    page.curve(points, {series_colour(k), 1.5, "3 4"});
  }
  return any;
}

}  // namespace

double percent_within(std::span<const ViewOutcome> outcomes, int most, bool with_symmetry) {
  if (outcomes.empty()) return 0;
  const auto right = std::count_if(outcomes.begin(), outcomes.end(), [&](const ViewOutcome& o) {
    const int rank = with_symmetry ? o.rank_with_symmetry : o.rank;
    return rank >= 1 && rank <= most;
  });
  return 100.0 * static_cast<double>(right) / static_cast<double>(outcomes.size());
}

std::string rank_svg(const Evaluation& evaluation, const ThesisRanks& thesis) {
  std::vector<std::string> names;
  for (const ObjectEvaluation& object : evaluation.objects) names.push_back(object.object);
  const double second = kAxisLeft_px + kSide_px + kGap_px + kAxisLeft_px;
  const double legend = second + kSide_px + 24;
  const double height = std::max(kTop_px + kSide_px + kAxisBelow_px,
                                 kTop_px + 56 + kLegendLine_px * static_cast<double>(names.size()));
  SvgPage page(
      legend + std::max(legend_width_px(names), 150.0) + 16, height,
      fmt::format("Rank of the right class, {} views an object", evaluation.settings.views));
  PlotPanel plain = panel_at(page, kAxisLeft_px, "without symmetry");
  PlotPanel alike = panel_at(page, second, "modulo the object's rotations");
  const bool has_thesis = draw_thesis(page, plain, evaluation, thesis);
  draw_ours(plain, evaluation, false);
  draw_ours(alike, evaluation, true);
  page.legend({legend, kTop_px}, names);
  if (has_thesis) {
    const double y = kTop_px + kLegendLine_px * (static_cast<double>(names.size()) + 1);
    page.line({legend, y}, {legend + 22, y}, {"#444444", 1.5, "3 4"});
    page.text({legend + 30, y + 4.5}, "thesis, on the left");
  }
  return page.document();
}

}  // namespace aspect
