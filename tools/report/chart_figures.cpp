#include "tools/report/chart_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace aspect {
namespace {

// A field with axes; x and y run from 0 (or a first value) to the last tick.
struct Chart {
  double left = 0, top = 0, width = 0, height = 0;
  double x_least = 0, x_most = 1, y_most = 1;

  double x(double value) const { return left + width * (value - x_least) / (x_most - x_least); }
  double y(double value) const { return top + height * (1 - value / y_most); }
};

// 1, 2 or 5 times a power of ten, about a quarter of the whole.
double tick_step(double most) {
  const double power = std::pow(10, std::floor(std::log10(std::max(most, 1e-9) / 4)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (most / (factor * power) <= 5) return factor * power;
  return 10 * power;
}

std::string y_ticks(const Chart& chart, double step, double factor, std::string_view unit) {
  std::string drawn;
  for (double value = 0; value <= chart.y_most * 1.0001; value += step) {
    drawn += svg_line(chart.left, chart.y(value), chart.left + chart.width, chart.y(value));
    drawn += svg_text(chart.left - 6, chart.y(value) + 4,
                      fmt::format("{:.7g}{}", value * factor, unit), {11, "end", true});
  }
  return drawn;
}

struct Series {
  std::vector<Eigen::Vector2d> points;
  std::string colour, dashes;
  double width = 1;
  const char* css = "series";
};

std::string drawn(const Chart& chart, const Series& series) {
  std::string line, dots;
  for (const Eigen::Vector2d& p : series.points) {
    fmt::format_to(std::back_inserter(line), "{:.1f},{:.1f} ", chart.x(p.x()), chart.y(p.y()));
    if (series.points.size() <= 12)
      dots += fmt::format(
          "<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\"/>", series.css,
          chart.x(p.x()), chart.y(p.y()), 1.5 + series.width / 1.5, series.colour);
  }
  return fmt::format(
             "<polyline class=\"{}\" points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
             "stroke-linejoin=\"round\"{}/>",
             series.css, line, series.colour, series.width,
             series.dashes.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", series.dashes)) +
         dots;
}

constexpr const char* kOwn = "#1b5e9c";
constexpr std::array kThesisColours = {"#b9770e", "#1a7f4b", "#8e44ad", "#c0392b", "#69707a"};

std::string threshold_words(const ThesisRow& row) {
  const auto thousands = [](double value) { return fmt::format("{:.7g}k", value / 1000); };
  if (row.threshold == row.cluster_threshold) return thousands(row.threshold);
  return thousands(row.threshold) + "/" + thousands(row.cluster_threshold);
}

// The thesis's rows of one pair of thresholds, by level.
std::map<std::pair<double, double>, std::vector<ThesisRow>> by_threshold(
    const std::vector<ThesisRow>& rows) {
  std::map<std::pair<double, double>, std::vector<ThesisRow>> groups;
  for (const ThesisRow& row : rows) groups[{row.threshold, row.cluster_threshold}].push_back(row);
  return groups;
}

void add_level_axis(const Chart& chart, std::string_view title, SvgFigure& figure) {
  for (double level = chart.x_least; level <= chart.x_most; ++level)
    figure.body += svg_text(chart.x(level), chart.top + chart.height + 16,
                            fmt::format("{:.0f}", level), {11, "middle", true});
  figure.body += svg_text(chart.left + chart.width / 2, chart.top + chart.height + 32, "level",
                          {11, "middle", true});
  figure.body += svg_text(chart.left, chart.top - 10, title, {12, "start", false, true});
}

// ---- confusions

enum class Answer { right, near, wrong };

struct AnswerLook {
  const char *css, *colour;
};
AnswerLook look_of(Answer answer) {
  if (answer == Answer::wrong) return {"wrong", "#c0392b"};
  return answer == Answer::right ? AnswerLook{"right", "#1b5e9c"} : AnswerLook{"near", "#b9770e"};
}

struct ConfusionCell {
  int views = 0, right = 0, wrong = 0;

  Answer answer() const {
    if (wrong > 0) return Answer::wrong;
    return right > 0 ? Answer::right : Answer::near;
  }
};

// By row and column; the column behind the last aspect: not found.
using ConfusionCells = std::map<std::pair<std::size_t, std::size_t>, ConfusionCell>;

ConfusionCells confusion_cells(const ReportContents& contents) {
  const std::size_t count = contents.model.index.statistics.index.classes;
  ConfusionCells cells;
  for (const TriedView& view : contents.explanation.tried_views) {
    const auto row = static_cast<std::size_t>(view.aspect);
    if (view.aspect < 0 || row >= count) continue;
    const auto column = view.taken_for ? static_cast<std::size_t>(*view.taken_for) : count;
    ConfusionCell& cell = cells[{row, column}];
    ++cell.views;
    cell.right += view.is_right ? 1 : 0;
    cell.wrong += view.is_wrong ? 1 : 0;
  }
  return cells;
}

// Where the cells are.
struct ConfusionGrid {
  std::size_t count = 0;  // aspects
  double left = 46, top = 46, side = 0;

  explicit ConfusionGrid(std::size_t aspects)
      : count(aspects), side(std::clamp(520 / static_cast<double>(aspects + 1), 2.0, 22.0)) {}

  double field() const { return side * static_cast<double>(count); }
  // The column behind the last stands a little apart.
  double at(std::size_t k) const {
    return side * static_cast<double>(k) + (k == count ? 0.6 * side + 4 : 0);
  }
};

std::string grid_drawn(const ConfusionGrid& grid) {
  std::string drawn = fmt::format(
      "<rect class=\"field\" x=\"{0}\" y=\"{1}\" width=\"{2:.1f}\" height=\"{2:.1f}\" "
      "fill=\"none\" "
      "stroke=\"#c6cbd2\"/>",
      grid.left, grid.top, grid.field());
  const double half = grid.side / 2;
  const std::size_t every = grid.side >= 14 ? 1 : grid.side >= 6 ? 5 : grid.side >= 3 ? 10 : 50;
  for (std::size_t k = 0; k < grid.count; k += every) {
    const std::string label = std::to_string(k);
    drawn += svg_text(grid.left - 5, grid.top + grid.at(k) + half + 3.5, label, {10, "end", true});
    drawn += svg_text(grid.left + grid.at(k) + half, grid.top - 6, label, {10, "middle", true});
  }
  drawn +=
      svg_text(grid.left + grid.at(grid.count) + half, grid.top - 6, "none", {10, "middle", true});
  drawn += svg_text(grid.left + grid.field() / 2, 18, "taken for", {12, "middle"});
  const double middle = grid.top + grid.field() / 2;
  return drawn + fmt::format("<g transform=\"rotate(-90 12 {:.1f})\">{}</g>", middle,
                             svg_text(12, middle, "seen from", {12, "middle"}));
}

std::string cells_drawn(const ConfusionGrid& grid, const ConfusionCells& cells) {
  int most = 1;
  for (const auto& [place, cell] : cells) most = std::max(most, cell.views);
  std::string drawn;
  for (const auto& [place, cell] : cells) {
    const auto [row, column] = place;
    const bool is_found = column < grid.count;
    const std::string words = !is_found       ? "was not found"
                              : column == row ? "was recognised"
                                              : fmt::format("was taken for {}", column);
    // What went wrong is seen, however rare it is.
    const double opacity = cell.answer() != Answer::right
                               ? 1
                               : 0.35 + 0.65 * std::sqrt(static_cast<double>(cell.views) / most);
    drawn += fmt::format(
        "<rect class=\"cell {}\" data-aspect=\"{}\"{} data-views=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" "
        "width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\" fill-opacity=\"{:.2f}\"><title>aspect {} "
        "{}: {} {}</title></rect>",
        look_of(cell.answer()).css, row,
        is_found ? fmt::format(" data-taken-for=\"{}\"", column) : "", cell.views,
        grid.left + grid.at(column) + 0.3, grid.top + grid.at(row) + 0.3,
        std::max(grid.side - 0.6, 1.6), std::max(grid.side - 0.6, 1.6),
        look_of(cell.answer()).colour, opacity, row, words, cell.views,
        cell.views == 1 ? "view" : "views");
  }
  return drawn;
}

}  // namespace

SvgFigure coverage_figure(const ReportContents& contents) {
  const auto groups = by_threshold(contents.thesis);
  double most_clusters = 1;
  int last = 3, first = contents.levels.empty() ? 2 : contents.levels.front().level;
  for (const LevelCoverage& level : contents.levels) {
    last = std::max(last, level.level);
    most_clusters = std::max(most_clusters, static_cast<double>(level.clusters));
  }
  for (const ThesisRow& row : contents.thesis) {
    last = std::max(last, row.level);
    first = std::min(first, row.level);
    most_clusters = std::max(most_clusters, static_cast<double>(row.clusters));
  }
  const double step = tick_step(most_clusters);
  SvgFigure figure{760, 292, "area covered and number of aspects by level", {}};
  const Chart area{46, 30, 300, 190, static_cast<double>(first), static_cast<double>(last), 1};
  const Chart count{430,
                    30,
                    300,
                    190,
                    static_cast<double>(first),
                    static_cast<double>(last),
                    step * std::ceil(most_clusters / step)};
  figure.body = y_ticks(area, 0.25, 100, " %") + y_ticks(count, step, 1, "");
  add_level_axis(area, "area in patches of one aspect", figure);
  add_level_axis(count, "aspects", figure);
  double key_x = 46;
  const auto add = [&](const std::string& name, const Series& areas, const Series& counts) {
    figure.body += drawn(area, areas) + drawn(count, counts);
    figure.body += fmt::format(
        "<line class=\"series\" x1=\"{}\" y1=\"272\" x2=\"{}\" y2=\"272\" stroke=\"{}\" "
        "stroke-width=\"{}\"{}/>",
        key_x, key_x + 20, areas.colour, areas.width,
        areas.dashes.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", areas.dashes));
    figure.body += svg_text(key_x + 25, 276, name, {11, "start", true});
    key_x += 38 + 6.2 * static_cast<double>(name.size());
  };
  std::size_t k = 0;
  for (const auto& [thresholds, rows] : groups) {
    Series areas{{}, kThesisColours[k % kThesisColours.size()], "4 3", 1.3}, counts = areas;
    for (const ThesisRow& row : rows) {
      areas.points.emplace_back(row.level, row.area_fraction);
      counts.points.emplace_back(row.level, row.clusters);
    }
    add("thesis, " + threshold_words(rows.front()), areas, counts);
    ++k;
  }
  Series areas{{}, kOwn, "", 2.6, "series own"}, counts = areas;
  for (const LevelCoverage& level : contents.levels) {
    areas.points.emplace_back(level.level, level.area_fraction);
    counts.points.emplace_back(level.level, static_cast<double>(level.clusters));
  }
  add("this model", areas, counts);
  return figure;
}

SvgFigure areas_figure(const ReportContents& contents) {
  SvgFigure figure{420, 292, "share of the sphere that the largest aspects cover", {}};
  const Chart chart{
      52, 30, 350, 200, 0, static_cast<double>(std::max<std::size_t>(contents.aspects(), 1)), 1};
  figure.body = y_ticks(chart, 0.25, 100, " %");
  std::vector<double> sorted = contents.areas;
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  Series series{{{0, 0}}, kOwn, "", 2.2, "series own"};
  double sum = 0;
  for (std::size_t k = 0; k < sorted.size(); ++k)
    series.points.emplace_back(static_cast<double>(k + 1), sum += sorted[k]);
  figure.body += drawn(chart, series);
  const double step = std::max(1.0, tick_step(chart.x_most));
  for (double value = 0; value <= chart.x_most; value += step)
    figure.body += svg_text(chart.x(value), chart.top + chart.height + 16,
                            fmt::format("{:.0f}", value), {11, "middle", true});
  figure.body += svg_text(chart.left + chart.width / 2, chart.top + chart.height + 32,
                          "aspects, largest first", {11, "middle", true});
  figure.body +=
      svg_text(chart.left, chart.top - 10, "area covered together", {12, "start", false, true});
  const std::size_t kept = contents.model.index.statistics.index.classes;
  if (kept < contents.aspects()) {
    const double x = chart.x(static_cast<double>(kept));
    figure.body += svg_line(x, chart.top, x, chart.top + chart.height, "cut", "#c0392b", 1.2);
    figure.body += svg_text(x + 5, chart.top + chart.height - 8, "the index stops here", {11});
  }
  return figure;
}

SvgFigure confusion_figure(const ReportContents& contents) {
  const ConfusionGrid grid(contents.model.index.statistics.index.classes);
  SvgFigure figure{grid.left + grid.field() + grid.side + 70,
                   grid.top + grid.field() + 40,
                   "aspects seen and what they were taken for",
                   {}};
  figure.body = grid_drawn(grid) + cells_drawn(grid, confusion_cells(contents));
  double x = grid.left;
  for (const auto& [kind, words] : {std::pair{Answer::right, "right"},
                                    {Answer::near, "another aspect, but near"},
                                    {Answer::wrong, "wrong"}}) {
    figure.body += fmt::format(
        "<rect class=\"cell {}\" x=\"{:.0f}\" y=\"{:.1f}\" width=\"10\" height=\"10\" "
        "fill=\"{}\"/>",
        look_of(kind).css, x, grid.top + grid.field() + 18, look_of(kind).colour);
    figure.body += svg_text(x + 15, grid.top + grid.field() + 27, words, {11, "start", true});
    x += 30 + 6.4 * static_cast<double>(std::string_view(words).size());
  }
  figure.width = std::max(figure.width, x + 10);
  return figure;
}

}  // namespace aspect
