#include "compiler/aspects/compile_options.h"

#include <fmt/format.h>

namespace aspect {

namespace {

std::string sensor_key(const VisionParameters& v) {
  const std::string name(name_of(v.sensor));
  if (v.sensor != SensorKind::range) return name;
  return fmt::format("{} {} {} {} {} {}", name, v.range.step_length, v.range.steps_min,
                     v.range.steps_max, v.range.depth_step, v.range.normal_step_deg);
}

}  // namespace

std::string CompileOptions::store_key() const {
  const VisionParameters& v = vision;
  const MatchScales& m = match_scales;
  const std::string sensor = v.sensor == SensorKind::colour ? "" : "; sensor " + sensor_key(v);
  return fmt::format(
             "segmentation {} {} {} {} {} {} {} {} {}; matching {} {} {} {} {} {} limits {} {}",
             v.intensity_min, v.chroma_step, v.noise_steps, v.intensity_step, v.area_min_px,
             v.thickness_min_px, v.smooth, static_cast<int>(v.relation_choice), v.relations_max,
             m.share, m.area, m.position, m.second, m.direction, m.kind, cluster_threshold,
             match_limit_ms) +
         sensor;
}

MatchLimits CompileOptions::match_limits() const {
  MatchLimits limits{.cost = cluster_threshold};
  limits.time = std::chrono::nanoseconds(static_cast<std::int64_t>(match_limit_ms * 1e6));
  return limits;
}

}  // namespace aspect
