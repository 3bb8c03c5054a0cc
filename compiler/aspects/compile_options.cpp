#include "compiler/aspects/compile_options.h"

#include <fmt/format.h>

namespace aspect {

std::string CompileOptions::store_key() const {
  const VisionParameters& v = vision;
  const MatchScales& m = match_scales;
  return fmt::format(
      "segmentation {} {} {} {} {} {} {} {} {}; matching {} {} {} {} {} {} "
      "limits {} {}",
      v.intensity_min, v.chroma_step, v.noise_steps, v.intensity_step, v.area_min_px,
      v.thickness_min_px, v.smooth, static_cast<int>(v.relation_choice), v.relations_max, m.share,
      m.area, m.position, m.second, m.direction, m.kind, cluster_threshold, match_limit_ms);
}

MatchLimits CompileOptions::match_limits() const {
  MatchLimits limits{.cost = cluster_threshold};
  limits.time = std::chrono::nanoseconds(static_cast<std::int64_t>(match_limit_ms * 1e6));
  return limits;
}

}  // namespace aspect
