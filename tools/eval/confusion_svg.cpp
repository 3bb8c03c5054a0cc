#include "tools/eval/confusion_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tools/plot/svg_plot.h"

namespace aspect {
namespace {

constexpr double kTop_px = 62, kRight_px = 64, kScale_px = 16;
constexpr std::size_t kNameLetters = 24;

// Nearly white, so that empty cells are cells too, to a dark blue.
std::string shade(double share) {
  const auto mixed = [share](double light, double dark) {
    return static_cast<int>(std::lround(light + share * (dark - light)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mixed(241, 8), mixed(244, 48), mixed(248, 107));
}

struct HeatMap {
  std::vector<std::string> names;  // of the rows
  double left_px = 0, cell_px = 0, names_px = 0;

  explicit HeatMap(const Evaluation& evaluation) {
    for (const ObjectEvaluation& object : evaluation.objects)
      names.push_back(cut_text(object.object, kNameLetters));
    for (const std::string& name : names) names_px = std::max(names_px, text_width_px(name, 13));
    names_px = std::max(names_px, text_width_px("none", 13)) + 12;
    left_px = 40 + names_px;
    // Large enough for numbers, small enough for a page of any number of objects.
    cell_px = std::clamp(640 / static_cast<double>(names.size() + 1), 14.0, 72.0);
  }

  double column(std::size_t k) const { return left_px + cell_px * static_cast<double>(k); }
  double row(std::size_t k) const { return kTop_px + cell_px * static_cast<double>(k); }
};

void draw_row(SvgPage& page, const HeatMap& map, std::size_t truth,
              const std::vector<int>& counts) {
  const double size = std::clamp(map.cell_px * 0.3, 7.0, 14.0);
  const double whole = std::max(1, std::accumulate(counts.begin(), counts.end(), 0));
  const double middle = map.row(truth) + map.cell_px / 2 + size * 0.36;
  page.text({map.left_px - 8, middle}, map.names[truth], {PlotAnchor::end});
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const double share = counts[k] / whole;
    const std::string found = k < map.names.size() ? map.names[k] : "none";
    page.bar({map.column(k), map.row(truth), map.cell_px - 1, map.cell_px - 1}, shade(share),
             fmt::format("{} taken for {}: {} of {:g}", map.names[truth], found, counts[k], whole));
    if (counts[k] > 0)
      page.text({map.column(k) + map.cell_px / 2, middle}, fmt::to_string(counts[k]),
                {PlotAnchor::middle, size, share > 0.5 ? "#ffffff" : "#111111"});
  }
  page.text({map.column(counts.size()) + 8, middle},
            fmt::format("{:.1f} %", 100 * counts[truth] / whole),
            {PlotAnchor::start, std::min(13.0, size + 1), "#222222"});
}

// The share of a row by its shade.
void draw_scale(SvgPage& page, double left, double top, double height) {
  constexpr int kSteps = 20;
  for (int k = 0; k < kSteps; ++k)
    page.bar({left, top + height * (kSteps - 1 - k) / kSteps, kScale_px, height / kSteps + 0.3},
             shade((k + 0.5) / kSteps));
  for (const int percent : {0, 50, 100})
    page.text({left + kScale_px + 6, top + height * (100 - percent) / 100 + 4},
              fmt::format("{} %", percent), {PlotAnchor::start, 12});
}

}  // namespace

std::string confusion_svg(const Evaluation& evaluation) {
  const HeatMap map(evaluation);
  const std::vector<std::vector<int>>& counts = evaluation.confusion->counts;
  const double right = map.column(map.names.size() + 1), bottom = map.row(map.names.size());
  const std::string title =
      fmt::format("Which object comes first, of {} views of each", evaluation.settings.views);
  const double scale_left = right + kRight_px + 20;
  SvgPage page(std::max(scale_left + kScale_px + 56, text_width_px(title, 16) + 40),
               bottom + map.names_px + 44, title);
  page.text({right + 8, kTop_px - 8}, "right", {PlotAnchor::start, 12, "#555555"});
  for (std::size_t truth = 0; truth < counts.size(); ++truth)
    draw_row(page, map, truth, counts[truth]);
  for (std::size_t k = 0; k <= map.names.size(); ++k)
    page.text({map.column(k) + map.cell_px / 2 + 4, bottom + 8},
              k < map.names.size() ? map.names[k] : "none",
              {PlotAnchor::end, 13, "#222222", false, true});
  page.text({(map.left_px + right) / 2, bottom + map.names_px + 32}, "object that comes first",
            {PlotAnchor::middle});
  page.text({22, (kTop_px + bottom) / 2}, "object that is there",
            {PlotAnchor::middle, 13, "#222222", false, true});
  draw_scale(page, scale_left, kTop_px, std::min(160.0, bottom - kTop_px));
  page.text({scale_left, kTop_px - 8}, "of a row", {PlotAnchor::start, 12, "#555555"});
  return page.document();
}

}  // namespace aspect
