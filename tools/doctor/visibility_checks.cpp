#include "tools/doctor/visibility_checks.h"

#include <fmt/format.h>

#include <algorithm>

namespace aspect {
namespace {

constexpr std::string_view kGroup = "visibility";

struct Lost {
  std::vector<std::size_t> parts;
  std::size_t most_px = 0, least_px = 0;

  void add(std::size_t part, std::size_t pixels) {
    least_px = parts.empty() ? pixels : std::min(least_px, pixels);
    most_px = std::max(most_px, pixels);
    parts.push_back(part + 1);
  }
  std::string pixels() const {
    return least_px == most_px ? fmt::format("{}", most_px)
                               : fmt::format("{} to {}", least_px, most_px);
  }
  void append(Finding finding, std::vector<Finding>& findings) const {
    if (parts.empty()) return;
    finding.count = parts.size();
    for (const std::size_t part : parts) finding.marks.primitives.push_back(part - 1);
    finding.where.assign(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                            parts.size(), Finding::kMostPlaces)));
    findings.push_back(std::move(finding));
  }
};

bool is_dark(const Sight::Part& part) {
  return 2 * part.dark_px > part.seen_px;
}

}  // namespace

std::vector<Finding> check_visibility(const Sight& sight, const VisionParameters& vision,
                                      double distance,
                                      const std::function<bool(std::size_t)>& is_known) {
  Lost small, thin, merged, hidden;
  for (std::size_t k = 0; k < sight.parts.size(); ++k) {
    const Sight::Part& part = sight.parts[k];
    if (part.most_px == 0)
      hidden.add(k, 0);
    else if (part.kept_px > 0 || is_dark(part) || (is_known && is_known(k)))
      continue;
    else if (part.most_px < static_cast<std::size_t>(vision.area_min_px))
      small.add(k, part.most_px);
    else if (part.thin_px > 0)
      thin.add(k, part.most_px);
    else
      merged.add(k, part.most_px);
  }
  std::vector<Finding> findings;
  const std::string where = fmt::format("at distance {:g}", distance);
  small.append(
      {kGroup,
       "part_too_small",
       Severity::warning,
       fmt::format("parts that show fewer pixels than area_min_px {} {}: {}, of {} at most",
                   vision.area_min_px, where, small.parts.size(), small.pixels()),
       "colour them like what they are on, take larger pictures, come nearer, or lower "
       "area_min_px",
       0,
       {},
       false},
      findings);
  thin.append({kGroup,
               "part_too_thin",
               Severity::warning,
               fmt::format("parts thinner than thickness_min_px {:g} {}: {}, of {} pixels at most",
                           static_cast<double>(vision.thickness_min_px), where, thin.parts.size(),
                           thin.pixels()),
               "colour them like what they are on, take larger pictures, come nearer, or lower "
               "thickness_min_px",
               0,
               {},
               false},
              findings);
  merged.append(
      {kGroup,
       "part_merges",
       Severity::warning,
       fmt::format("parts that are no contour of their colour {}, but merge with what is "
                   "around them: {}, of {} pixels at most",
                   where, merged.parts.size(), merged.pixels()),
       "make them three pixels thick at least, or their colour more unlike that around them",
       0,
       {},
       false},
      findings);
  hidden.append(
      {kGroup,
       "part_hidden",
       Severity::note,
       fmt::format("parts that are seen from none of 42 directions: {}", hidden.parts.size()),
       "nothing to do; removing them makes rendering quicker",
       0,
       {},
       false},
      findings);
  return findings;
}

}  // namespace aspect
