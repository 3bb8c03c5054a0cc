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
  struct Cell {
    int views = 0, right = 0, wrong = 0;
  };
  const std::size_t count = contents.model.index.statistics.index.classes;
  std::map<std::pair<std::size_t, std::size_t>, Cell> cells;  // row, column; `count`: not found
  for (const TriedView& view : contents.explanation.tried_views) {
    const auto row = static_cast<std::size_t>(view.aspect);
    const auto column = view.taken_for ? static_cast<std::size_t>(*view.taken_for) : count;
    if (view.aspect < 0 || row >= count) continue;
    Cell& cell = cells[{row, column}];
    ++cell.views;
    cell.right += view.is_right ? 1 : 0;
    cell.wrong += view.is_wrong ? 1 : 0;
  }
  const double side = std::clamp(520 / static_cast<double>(count + 1), 2.0, 22.0);
  const double field = side * static_cast<double>(count), left = 46, top = 46;
  SvgFigure figure{
      left + field + side + 70, top + field + 40, "aspects seen and what they were taken for", {}};
  const auto at = [&](std::size_t k) {
    return side * static_cast<double>(k) + (k == count ? 0.6 * side + 4 : 0);
  };
  figure.body = fmt::format(
      "<rect class=\"field\" x=\"{}\" y=\"{}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" "
      "stroke=\"#c6cbd2\"/>",
      left, top, field, field);
  const std::size_t every = side >= 14 ? 1 : side >= 6 ? 5 : side >= 3 ? 10 : 50;
  for (std::size_t k = 0; k < count; k += every) {
    const std::string label = std::to_string(k);
    figure.body += svg_text(left - 5, top + at(k) + side / 2 + 3.5, label, {10, "end", true});
    figure.body += svg_text(left + at(k) + side / 2, top - 6, label, {10, "middle", true});
  }
  int most = 1;
  for (const auto& [place, cell] : cells) most = std::max(most, cell.views);
  for (const auto& [place, cell] : cells) {
    const char* kind = cell.wrong > 0 ? "wrong" : cell.right > 0 ? "right" : "near";
    const char* colour = cell.wrong > 0 ? "#c0392b" : cell.right > 0 ? "#1b5e9c" : "#b9770e";
    const double opacity = cell.wrong > 0 || kind[0] == 'n'
                               ? 1
                               : 0.35 + 0.65 * std::sqrt(static_cast<double>(cell.views) / most);
    figure.body += fmt::format(
        "<rect class=\"cell {}\" data-aspect=\"{}\"{} x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
        "height=\"{:.1f}\" fill=\"{}\" fill-opacity=\"{:.2f}\"><title>aspect {} {}: {} "
        "views</title>"
        "</rect>",
        kind, place.first,
        place.second < count ? fmt::format(" data-taken-for=\"{}\"", place.second) : "",
        left + at(place.second) + 0.3, top + at(place.first) + 0.3, std::max(side - 0.6, 1.6),
        std::max(side - 0.6, 1.6), colour, opacity, place.first,
        place.second == count         ? std::string("was not found")
        : place.second == place.first ? std::string("was recognised")
                                      : fmt::format("was taken for {}", place.second),
        cell.views);
  }
  figure.body += svg_text(left + at(count) + side / 2, top - 6, "none", {10, "middle", true});
  figure.body += svg_text(left + field / 2, 18, "taken for", {12, "middle"});
  figure.body += fmt::format("<g transform=\"rotate(-90 12 {0:.1f})\">{1}</g>", top + field / 2,
                             svg_text(12, top + field / 2, "seen from", {12, "middle"}));
  double x = left;
  for (const auto& [css, colour, words] : {std::tuple{"right", "#1b5e9c", "right"},
                                           {"near", "#b9770e", "another aspect, but near"},
                                           {"wrong", "#c0392b", "wrong"}}) {
    figure.body += fmt::format(
        "<rect class=\"cell {}\" x=\"{:.0f}\" y=\"{:.1f}\" width=\"10\" height=\"10\" "
        "fill=\"{}\"/>",
        css, x, top + field + 18, colour);
    figure.body += svg_text(x + 15, top + field + 27, words, {11, "start", true});
    x += 30 + 6.4 * static_cast<double>(std::string_view(words).size());
  }
  figure.width = std::max(figure.width, x + 10);
  return figure;
}

}  // namespace aspect
