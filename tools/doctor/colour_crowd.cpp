#include "tools/doctor/colour_crowd.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "compiler/aspects/colour_separation.h"
#include "compiler/scene/colour_merging.h"
#include "tools/doctor/colour_checks.h"

namespace aspect {
namespace {

constexpr double kNearlyAll = 0.95;  // of the surface that is seen
constexpr std::array<std::size_t, 8> kCounts = {2, 3, 4, 5, 6, 8, 12, 16};

std::vector<WeighedColour> seen_colours(const ColourGroups& groups, const Sight& sight) {
  std::vector<WeighedColour> colours;
  for (const ColourGroups::Group& group : groups.groups) colours.push_back({group.seen, 0});
  for (std::size_t k = 0; k < sight.parts.size(); ++k)
    if (groups.group_of[k] != ColourGroups::kNone)
      colours[groups.group_of[k]].weight += static_cast<double>(sight.parts[k].seen_px);
  return colours;
}

// The least number of colours in which the segmentation sees nearly all as it is.
std::size_t enough_colours(const std::vector<WeighedColour>& colours,
                           const VisionParameters& vision) {
  double whole = 0;
  for (const WeighedColour& colour : colours) whole += colour.weight;
  for (const std::size_t count : kCounts) {
    const ColourClusters clusters = cluster_colours(colours, count);
    double kept = 0;
    for (std::size_t k = 0; k < colours.size(); ++k)
      if (colour_separation(colours[k].colour, clusters.colours[clusters.cluster_of[k]], vision) <
          1)
        kept += colours[k].weight;
    if (kept >= kNearlyAll * whole) return count;
  }
  return kCounts.back();
}

void note_pairs(const ColourGroups& groups, const Sight& sight, const VisionParameters& vision,
                ColourCrowd& crowd) {
  std::vector<std::size_t> first_of(groups.groups.size(), 0);
  for (std::size_t k = groups.group_of.size(); k-- > 0;)
    if (groups.group_of[k] != ColourGroups::kNone) first_of[groups.group_of[k]] = k + 1;
  for (const auto& [pair, border] : sight.borders) {
    const auto &a = groups.groups[pair.first], &b = groups.groups[pair.second];
    if (is_inseparable(a, b, vision))
      crowd.touching.push_back({inseparable_words(a, b, vision),
                                border.pixels,
                                {first_of[pair.first], first_of[pair.second]}});
  }
  std::stable_sort(crowd.touching.begin(), crowd.touching.end(),
                   [](const auto& a, const auto& b) { return a.count > b.count; });
}

}  // namespace

bool ColourCrowd::has_primitive(const ColourGroups& groups, std::size_t primitive) const {
  const std::size_t group = groups.group_of[primitive];
  return is_one() && group != ColourGroups::kNone && has[group];
}

ColourCrowd find_crowd(const ColourGroups& groups, const Sight& sight,
                       const VisionParameters& vision) {
  ColourCrowd crowd;
  crowd.has.assign(groups.groups.size(), false);
  if (vision.sensor != SensorKind::colour && vision.sensor != SensorKind::grey) return crowd;
  for (const auto& [pair, border] : sight.borders) {
    if (!is_inseparable(groups.groups[pair.first], groups.groups[pair.second], vision)) continue;
    ++crowd.pairs;
    crowd.has[pair.first] = crowd.has[pair.second] = true;
  }
  if (crowd.pairs > ColourCrowd::kFewPairs) note_pairs(groups, sight, vision, crowd);
  crowd.colours = static_cast<std::size_t>(std::count(crowd.has.begin(), crowd.has.end(), true));
  if (!crowd.is_one()) return crowd;
  const std::vector<WeighedColour> colours = seen_colours(groups, sight);
  double whole = 0, crowded = 0;
  for (std::size_t k = 0; k < colours.size(); ++k) {
    whole += colours[k].weight;
    if (crowd.has[k]) crowded += colours[k].weight;
  }
  crowd.share = whole > 0 ? crowded / whole : 0;
  crowd.enough = enough_colours(colours, vision);
  return crowd;
}

Finding crowd_finding(const ColourCrowd& crowd, const ColourGroups& groups, bool is_mesh,
                      const std::string& file) {
  const std::string cure =
      is_mesh ? fmt::format(
                    "merge them: aspectc doctor {} --merge-colours {} shows the mesh in so "
                    "few; compile with the same, or with merge_colours under [mesh]",
                    file, crowd.enough)
              : "use fewer colours, or ones that differ in the ratio of r : g : b; --fix moves "
                "those that touch apart";
  Finding finding{
      "colours",
      "crowded_colours",
      Severity::warning,
      fmt::format("{} colours, and {:.0f} % of the surface is in {} of them that touch others "
                  "too like them, in {} pairs: whatever they show counts as one region or "
                  "as crumbs",
                  groups.groups.size(), 100 * crowd.share, crowd.colours, crowd.pairs),
      cure,
      crowd.pairs,
      {},
      !is_mesh};
  finding.examples = crowd.touching;
  for (std::size_t k = 0; k < groups.group_of.size(); ++k)
    if (crowd.has_primitive(groups, k)) finding.marks.primitives.push_back(k);
  return finding;
}

}  // namespace aspect
