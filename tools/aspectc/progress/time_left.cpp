#include "tools/aspectc/progress/time_left.h"

namespace aspect {

std::optional<double> seconds_left(const Progress& progress, int last_level,
                                   const TimeSpent& spent) {
  double views_to_come = static_cast<double>(progress.views_wanted - progress.views_done);
  double views_of_level = static_cast<double>(progress.views_of_level);
  for (int level = progress.level; level < last_level; ++level)
    views_to_come += views_of_level *= 2;
  views_to_come += views_of_level * (progress.border_rounds - progress.border_round);
  double left_s = 0;
  if (views_to_come > 0) {
    if (progress.views_total == 0) return std::nullopt;
    left_s = views_to_come * spent.run_s / static_cast<double>(progress.views_total);
  }
  const std::size_t matches_to_come = progress.matches_wanted - progress.matches_done;
  if (matches_to_come == 0) return left_s;
  if (progress.matches_done == 0) return std::nullopt;
  return left_s + spent.matches_s * static_cast<double>(matches_to_come) /
                      static_cast<double>(progress.matches_done);
}

}  // namespace aspect
