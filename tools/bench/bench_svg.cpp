#include "tools/bench/bench_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "tools/plot/svg_plot.h"

namespace aspect {
namespace {

constexpr double kPage_px = 900, kRow_px = 34, kBar_px = 22, kHead_px = 46, kNames_px = 240;
constexpr std::size_t kMostRows = 200;  // more than aspect-bench has

// "observe", "cube" of observe/cube; the second part may be empty.
std::pair<std::string, std::string> parts_of(const std::string& name) {
  const std::size_t slash = name.find('/');
  if (slash == std::string::npos) return {name, ""};
  return {name.substr(0, slash), name.substr(slash + 1)};
}

struct Stage {
  std::string name;
  double us = 0;
};

struct ObjectStages {
  std::string object;
  std::vector<Stage> stages;

  double whole_us() const {
    double sum = 0;
    for (const Stage& stage : stages) sum += stage.us;
    return sum;
  }
};

struct LevelCurve {
  std::string object;
  std::vector<PlotPoint> points;  // level, seconds; by level
};

struct Costs {
  std::vector<ObjectStages> views;
  std::vector<LevelCurve> levels;
  std::vector<Stage> others;
};

template <typename Entry>
Entry& entry_of(std::vector<Entry>& entries, const std::string& object) {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const Entry& entry) { return entry.object == object; });
  return found == entries.end() ? entries.emplace_back(Entry{object, {}}) : *found;
}

// "segment" of 4_segment_us; counters come in the order of their numbers.
std::optional<std::string> stage_name(const std::string& counter) {
  if (counter.size() < 6 || counter[0] < '0' || counter[0] > '9' || counter[1] != '_' ||
      !counter.ends_with("_us"))
    return std::nullopt;
  return counter.substr(2, counter.size() - 5);
}

// Of compile_to_level/cube/level:3/process_time: cube and 3.
std::optional<std::pair<std::string, int>> object_and_level(const std::string& rest) {
  const std::size_t at = rest.find("/level:");
  if (at == std::string::npos) return std::nullopt;
  int level = 0;
  const char* first = rest.data() + at + 7;
  const auto [end, error] = std::from_chars(first, rest.data() + rest.size(), level);
  if (error != std::errc() || level < 0 || level > 12) return std::nullopt;
  return std::pair{rest.substr(0, at), level};
}

Costs costs_of(std::span<const BenchResult> results) {
  Costs costs;
  for (const BenchResult& result : results.first(std::min(results.size(), kMostRows))) {
    const auto [kind, rest] = parts_of(result.name);
    if (kind == "observe") {
      for (const auto& [counter, us] : result.counters)
        if (const auto stage = stage_name(counter))
          entry_of(costs.views, rest).stages.push_back({*stage, std::max(0.0, us)});
    } else if (kind == "match" || kind == "store") {
      entry_of(costs.views, rest).stages.push_back({kind, result.cpu_us});
    } else if (const auto at = object_and_level(rest); at && result.cpu_us > 0) {
      entry_of(costs.levels, at->first)
          .points.push_back({static_cast<double>(at->second), 1e-6 * result.cpu_us});
    } else if (result.cpu_us > 0) {
      costs.others.push_back({result.name, result.cpu_us});
    }
  }
  for (LevelCurve& curve : costs.levels)
    std::sort(curve.points.begin(), curve.points.end(),
              [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
  return costs;
}

std::string time_words(double us) {
  if (us < 1) return fmt::format("{:.3g} ns", 1000 * us);
  if (us < 1000) return fmt::format("{:.3g} µs", us);
  return us < 1e6 ? fmt::format("{:.3g} ms", us / 1000) : fmt::format("{:.3g} s", us / 1e6);
}

// Stages of all objects in the order in which they come.
std::vector<std::string> stage_names(const std::vector<ObjectStages>& views) {
  std::vector<std::string> names;
  for (const ObjectStages& object : views)
    for (const Stage& stage : object.stages)
      if (std::find(names.begin(), names.end(), stage.name) == names.end())
        names.push_back(stage.name);
  return names;
}

// Eight differ: the series' six colours, and the palette's yellow and a grey.
std::string stage_colour(std::size_t place) {
  if (place % 8 == 6) return "#f0e442";
  return place % 8 == 7 ? "#8c8c8c" : series_colour(place % 8);
}

double views_height(const Costs& costs) {
  if (costs.views.empty()) return 0;
  return kHead_px + kRow_px * static_cast<double>(costs.views.size()) + kAxisBelow_px + 44;
}

void draw_views(SvgPage& page, double top, const std::vector<ObjectStages>& views) {
  page.text({20, top + 18}, "A view of the compiler, stage by stage, on one core",
            {PlotAnchor::start, 14, "#111111", true});
  double most = 0;
  for (const ObjectStages& object : views) most = std::max(most, object.whole_us());
  const PlotBox box{kNames_px, top + kHead_px, kPage_px - kNames_px - 90,
                    kRow_px * static_cast<double>(views.size())};
  PlotPanel panel(page, box, {"processor time a view, µs", 0, most > 0 ? 1.02 * most : 1},
                  {"", 0, 1, false, {{-1, ""}}});
  const std::vector<std::string> names = stage_names(views);
  for (std::size_t row = 0; row < views.size(); ++row) {
    const double y = box.top + kRow_px * static_cast<double>(row) + (kRow_px - kBar_px) / 2;
    double before = 0;
    for (const Stage& stage : views[row].stages) {
      const auto place = static_cast<std::size_t>(
          std::find(names.begin(), names.end(), stage.name) - names.begin());
      const double left = panel.at(before, 0).x;
      before += stage.us;
      page.bar({left, y, panel.at(before, 0).x - left - 0.7, kBar_px}, stage_colour(place),
               fmt::format("{}: {}", stage.name, time_words(stage.us)));
    }
    page.text({box.left - 8, y + 16}, cut_text(views[row].object, 30), {PlotAnchor::end});
    page.text({panel.at(before, 0).x + 6, y + 16}, time_words(before), {PlotAnchor::start, 12});
  }
  double x = kNames_px;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const double y = box.bottom() + kAxisBelow_px + 12;
    page.bar({x, y, 12, 12}, stage_colour(k));
    page.text({x + 17, y + 11}, names[k], {PlotAnchor::start, 12});
    x += 32 + text_width_px(names[k], 12);
  }
}

double levels_height(const Costs& costs) {
  return costs.levels.empty() ? 0 : kHead_px + 300 + kAxisBelow_px + 24;
}

void draw_levels(SvgPage& page, double top, const std::vector<LevelCurve>& levels) {
  page.text({20, top + 18}, "Compiling by the level of the viewing sphere",
            {PlotAnchor::start, 14, "#111111", true});
  double first = 12, last = 0, least = 1e9, most = 0;
  std::vector<std::string> names;
  for (const LevelCurve& curve : levels) {
    names.push_back(curve.object);
    for (const PlotPoint& p : curve.points) {
      first = std::min(first, p.x);
      last = std::max(last, p.x);
      least = std::min(least, p.y);
      most = std::max(most, p.y);
    }
  }
  std::vector<PlotTick> ticks;
  for (int level = static_cast<int>(first); level <= static_cast<int>(last); ++level)
    ticks.push_back({static_cast<double>(level), std::to_string(level)});
  PlotPanel panel(page, {kNames_px, top + kHead_px, 420, 300},
                  {"level", first - 0.25, last + 0.25, false, ticks},
                  {"processor time, s", std::pow(10, std::floor(std::log10(least))),
                   std::pow(10, std::floor(std::log10(most)) + 1), true});
  for (std::size_t k = 0; k < levels.size(); ++k) panel.curve(levels[k].points, k, true);
  page.legend({kNames_px + 440, top + kHead_px}, names);
}

double others_height(const Costs& costs) {
  if (costs.others.empty()) return 0;
  return kHead_px + kRow_px * static_cast<double>(costs.others.size()) + kAxisBelow_px + 24;
}

void draw_others(SvgPage& page, double top, const std::vector<Stage>& others) {
  page.text({20, top + 18}, "One iteration of all else", {PlotAnchor::start, 14, "#111111", true});
  double least = 1e12, most = 0;
  for (const Stage& stage : others) {
    least = std::min(least, stage.us);
    most = std::max(most, stage.us);
  }
  PlotAxis axis{"processor time, logarithmic", std::pow(10, std::floor(std::log10(least))),
                std::pow(10, std::floor(std::log10(most)) + 1), true};
  axis.ticks = round_ticks(axis);
  for (PlotTick& tick : axis.ticks) tick.text = time_words(tick.at);
  const PlotBox box{kNames_px, top + kHead_px, kPage_px - kNames_px - 90,
                    kRow_px * static_cast<double>(others.size())};
  PlotPanel panel(page, box, axis, {"", 0, 1, false, {{-1, ""}}});
  for (std::size_t row = 0; row < others.size(); ++row) {
    const double y = box.top + kRow_px * (static_cast<double>(row) + 0.5);
    const double x = panel.at(others[row].us, 0).x;
    page.line({box.left, y}, {x, y}, {series_colour(0), 2});
    page.mark({x, y}, 0, others[row].name);
    page.text({box.left - 8, y + 4}, cut_text(others[row].name, 36), {PlotAnchor::end, 12});
    page.text({x + 8, y + 4}, time_words(others[row].us), {PlotAnchor::start, 12});
  }
}

}  // namespace

Result<std::string> bench_svg(std::span<const BenchResult> results) {
  Costs costs = costs_of(results);
  std::erase_if(costs.views, [](const ObjectStages& object) { return object.stages.empty(); });
  if (costs.views.empty() && costs.levels.empty() && costs.others.empty())
    return Error{"nothing was measured that could be drawn; leave the filter out"};
  const double top = 44;
  const double levels_top = top + views_height(costs),
               others_top = levels_top + levels_height(costs);
  SvgPage page(kPage_px, others_top + others_height(costs), "What the stages cost");
  if (!costs.views.empty()) draw_views(page, top, costs.views);
  if (!costs.levels.empty()) draw_levels(page, levels_top, costs.levels);
  if (!costs.others.empty()) draw_others(page, others_top, costs.others);
  return page.document();
}

}  // namespace aspect
