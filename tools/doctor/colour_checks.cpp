#include "tools/doctor/colour_checks.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/aspects/colour_separation.h"

namespace aspect {
namespace {

constexpr std::string_view kGroup = "colours";
constexpr double kSomeMerge = 0.1;  // of a border's pixels; fewer are single ones at its ends
constexpr std::size_t kLeastBorder_px = 40;
constexpr std::size_t kMostDark = 5;         // more are one finding, with each as an example
constexpr std::size_t kMostCompared = 2000;  // colours, each with each

using Pair = std::pair<std::size_t, std::size_t>;

std::vector<std::size_t> primitives_of(const ColourGroups& groups, std::size_t group) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < groups.group_of.size(); ++k)
    if (groups.group_of[k] == group && found.size() < Finding::kMostPlaces) found.push_back(k + 1);
  return found;
}

// All of them, from 0.
void mark_group(const ColourGroups& groups, std::size_t group, FindingMarks& marks) {
  for (std::size_t k = 0; k < groups.group_of.size(); ++k)
    if (groups.group_of[k] == group) marks.primitives.push_back(k);
}

// Of two colours: the first surface of each.
std::vector<std::size_t> places_of(const ColourGroups& groups, const Pair& pair) {
  return {primitives_of(groups, pair.first).front(), primitives_of(groups, pair.second).front()};
}

Finding inseparable(const ColourGroups& groups, const Pair& pair, const Border& border,
                    const VisionParameters& vision) {
  return {kGroup,
          "inseparable_colours",
          Severity::warning,
          inseparable_words(groups.groups[pair.first], groups.groups[pair.second], vision),
          "move the colours apart, or lower chroma_step or noise_steps; --fix moves them",
          border.pixels,
          places_of(groups, pair),
          true};
}

Finding merged_in_shade(const ColourGroups& groups, const Pair& pair, const Border& border) {
  return {
      kGroup,
      "merged_by_shading",
      Severity::warning,
      fmt::format("{} touches {}: {:.0f} % of their border merges in the lamps' light, where "
                  "the separation falls to {:.2f}",
                  colour_words(groups.groups[pair.first].seen),
                  colour_words(groups.groups[pair.second].seen),
                  100.0 * static_cast<double>(border.merged) / static_cast<double>(border.pixels),
                  border.least_separation),
      "move the colours further apart, or use lamps of one white",
      border.merged,
      places_of(groups, pair),
      false};
}

Finding alike_note(const Sight& sight) {
  Finding note{kGroup,
               "same_colour_touches",
               Severity::note,
               "",
               "nothing to do where they are meant as one; otherwise give one another colour",
               0,
               {},
               false};
  for (const auto& [pair, pixels] : sight.alike_borders) {
    if (pixels < kLeastBorder_px) continue;
    ++note.count;
    note.marks.borders.push_back(pair);
    if (note.where.size() + 2 <= Finding::kMostPlaces)
      note.where.insert(note.where.end(), {pair.first + 1, pair.second + 1});
  }
  note.message =
      fmt::format("touching surfaces of one colour, each pair one contour: {} pairs", note.count);
  return note;
}

struct Seen {
  std::size_t pixels = 0, dark = 0;  // dark: counted as background
};

Finding dark_surface(const Scene& scene, const ColourGroups& groups, std::size_t group,
                     const Seen& seen, const VisionParameters& vision) {
  const Eigen::Vector3d& colour = groups.groups[group].seen;
  const auto share = static_cast<double>(seen.dark) / static_cast<double>(seen.pixels);
  Finding finding{
      kGroup,
      "dark_surface",
      scene.lights.empty() ? Severity::error : Severity::warning,
      fmt::format("{} has r + g + b of {:.0f} at most and counts as background below {}: {:.0f} "
                  "% of it is lost",
                  colour_words(colour), intensity_seen(colour, vision), vision.intensity_min,
                  100 * share),
      "brighten the colour or the light, or lower intensity_min",
      seen.dark,
      primitives_of(groups, group),
      false};
  mark_group(groups, group, finding.marks);
  return finding;
}

void put_worst_first(std::vector<FindingExample>& examples) {
  std::stable_sort(examples.begin(), examples.end(),
                   [](const auto& a, const auto& b) { return a.count > b.count; });
}

bool by_colour(const VisionParameters& vision) {
  return vision.sensor == SensorKind::colour || vision.sensor == SensorKind::grey;
}

}  // namespace

std::string inseparable_words(const ColourGroups::Group& a, const ColourGroups::Group& b,
                              const VisionParameters& vision) {
  const ColourGap gap = colour_gap(a.seen, b.seen, vision);
  return fmt::format(
      "{} touches {}: they differ by {:.2f}, and a step of {:.2f} counts as one region",
      colour_words(a.seen), colour_words(b.seen), gap.difference, gap.step);
}

bool is_background(const Eigen::Vector3d& colour, const VisionParameters& vision) {
  return intensity_seen(colour, vision) <= vision.intensity_min;
}

std::string colour_words(const Eigen::Vector3d& colour) {
  const Eigen::Vector3d share = 255 * colour / std::max(colour.sum(), 1e-9);
  return fmt::format("{:.3g} {:.3g} {:.3g} (shares {:.1f} {:.1f} {:.1f})", colour.x(), colour.y(),
                     colour.z(), share.x(), share.y(), share.z());
}

bool is_inseparable(const ColourGroups::Group& a, const ColourGroups::Group& b,
                    const VisionParameters& vision) {
  if (is_background(a.seen, vision) || is_background(b.seen, vision)) return false;
  return colour_separation(a.seen, b.seen, vision) < 1;
}

std::vector<Finding> check_missing(const Scene& scene, bool given) {
  std::vector<Finding> findings;
  for (const MissingColour& missing : scene.missing_colours) {
    Finding& finding = findings.emplace_back();
    finding.group = "colours";
    finding.code = "missing_colour";
    finding.severity = given ? Severity::note : Severity::error;
    finding.message = line_of(missing);
    finding.cure = fmt::format("{}{}", missing.cure, kOrGoOn);
    finding.count = std::max<std::size_t>(missing.parts.size(), 1);
  }
  return findings;
}

std::vector<Finding> check_colours(const ColourGroups& groups, const VisionParameters& vision) {
  if (!by_colour(vision)) return {};
  std::vector<std::size_t> apart;
  Finding alike{kGroup,
                "too_many_colours",
                Severity::warning,
                "",
                "use fewer colours, or ones that differ in the ratio of r : g : b and not only in "
                "brightness",
                0,
                {},
                false};
  std::string nearest;
  const std::size_t count = std::min(groups.groups.size(), kMostCompared);
  for (std::size_t k = 0; k < count; ++k) {
    const auto like = std::find_if(apart.begin(), apart.end(), [&](std::size_t other) {
      return is_inseparable(groups.groups[k], groups.groups[other], vision);
    });
    if (like == apart.end()) {
      apart.push_back(k);
      continue;
    }
    if (alike.count++ == 0)
      nearest = fmt::format("{} is like {}", colour_words(groups.groups[k].seen),
                            colour_words(groups.groups[*like].seen));
    if (alike.where.size() < Finding::kMostPlaces)
      alike.where.push_back(primitives_of(groups, k).front());
    mark_group(groups, k, alike.marks);
  }
  if (alike.count == 0) return {};
  alike.message = fmt::format("{} colours, of which {} can be told apart: {}{}", count,
                              apart.size(), nearest, alike.count > 1 ? ", and so on" : "");
  return {alike};
}

std::vector<Finding> check_borders(const Scene& scene, const ColourGroups& groups,
                                   const Sight& sight, const VisionParameters& vision) {
  if (!by_colour(vision)) return {};
  std::vector<Finding> findings;
  for (const auto& [pair, border] : sight.borders) {
    const auto merged = static_cast<double>(border.merged);
    if (is_inseparable(groups.groups[pair.first], groups.groups[pair.second], vision))
      findings.push_back(inseparable(groups, pair, border, vision));
    else if (!scene.lights.empty() && border.pixels >= kLeastBorder_px &&
             merged > kSomeMerge * static_cast<double>(border.pixels))
      findings.push_back(merged_in_shade(groups, pair, border));
    else
      continue;
    findings.back().marks.of_colours.push_back(pair);
  }
  if (Finding note = alike_note(sight); note.count > 0) findings.push_back(std::move(note));
  return findings;
}

std::vector<Finding> check_darkness(const Scene& scene, const ColourGroups& groups,
                                    const Sight& sight, const VisionParameters& vision) {
  if (!by_colour(vision)) return {};
  std::vector<Seen> seen(groups.groups.size());
  double whole_px = 0, lost_px = 0;
  for (std::size_t k = 0; k < sight.parts.size(); ++k) {
    whole_px += static_cast<double>(sight.parts[k].seen_px);
    if (groups.group_of[k] == ColourGroups::kNone) continue;
    seen[groups.group_of[k]].pixels += sight.parts[k].seen_px;
    seen[groups.group_of[k]].dark += sight.parts[k].dark_px;
  }
  std::vector<Finding> findings;
  for (std::size_t group = 0; group < seen.size(); ++group) {
    if (2 * seen[group].dark <= seen[group].pixels) continue;
    lost_px += static_cast<double>(seen[group].dark);
    findings.push_back(dark_surface(scene, groups, group, seen[group], vision));
  }
  if (findings.size() <= kMostDark) return findings;
  Finding all = findings.front();
  all.message = fmt::format(
      "{} colours are so dark that they count as background below {}: {:.0f} % of the "
      "surface is lost",
      findings.size(), vision.intensity_min, 100 * lost_px / whole_px);
  all.count = static_cast<std::size_t>(lost_px);
  all.where.clear();
  all.marks.primitives.clear();
  for (Finding& finding : findings) {
    all.examples.push_back({finding.message, finding.count, finding.where});
    all.marks.primitives.insert(all.marks.primitives.end(), finding.marks.primitives.begin(),
                                finding.marks.primitives.end());
  }
  put_worst_first(all.examples);
  return {all};
}

}  // namespace aspect
