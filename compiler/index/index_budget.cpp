#include "compiler/index/index_budget.h"

#include <algorithm>
#include <cmath>

#include "compiler/index/sphere_map_writer.h"

namespace aspect {
namespace {

constexpr double kFinestSpacing_deg = kFinestKeyViewSpacing_deg, kCoarsestSpacing_deg = 60,
                 kSpacingStep = 1.15;
// A step leaves up to a quarter of the budget unused; halving the last one so often, 3 %.
constexpr int kHalvings = 3;
constexpr std::size_t kMostMapBytes = 16 * 1024;

std::vector<std::uint8_t> map_of(const IndexContents& contents, std::size_t class_count) {
  return encode_sphere_map_within(contents.subdivision.sphere, contents.sphere_classes, class_count,
                                  std::min(kMostMapBytes, contents.options.max_index_bytes / 4));
}

}  // namespace

IndexSelection select_within(const IndexContents& contents, std::size_t budget,
                             const std::function<std::size_t(const IndexSelection&)>& bytes_of) {
  const std::size_t all = contents.clusters.size();
  IndexSelection selection{all, kFinestSpacing_deg, map_of(contents, all)};
  while (bytes_of(selection) > budget) {
    if (selection.key_view_spacing_deg >= kCoarsestSpacing_deg) {
      const auto first = [&](std::size_t class_count) {
        return IndexSelection{class_count, selection.key_view_spacing_deg,
                              map_of(contents, class_count)};
      };
      std::size_t fits = 0, too_many = all;
      while (too_many - fits > 1) {
        const std::size_t middle = (fits + too_many) / 2;
        (bytes_of(first(middle)) <= budget ? fits : too_many) = middle;
      }
      return first(fits);
    }
    selection.key_view_spacing_deg *= kSpacingStep;
  }
  if (selection.key_view_spacing_deg == kFinestSpacing_deg) return selection;
  double too_fine_deg = selection.key_view_spacing_deg / kSpacingStep;
  for (int k = 0; k < kHalvings; ++k) {
    IndexSelection finer = selection;
    finer.key_view_spacing_deg = std::sqrt(too_fine_deg * selection.key_view_spacing_deg);
    if (bytes_of(finer) <= budget)
      selection = std::move(finer);
    else
      too_fine_deg = finer.key_view_spacing_deg;
  }
  return selection;
}

}  // namespace aspect
