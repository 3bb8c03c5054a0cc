#include "compiler/aspects/compile_options.h"

#include <fmt/format.h>

namespace aspect {

std::string CompileOptions::store_key() const {
  const VisionParameters& v = vision;
  const MatchScales& m = match_scales;
  return fmt::format("segmentation {} {} {} {} {} {} {} {}; matching {} {} {} {} {} {} give up {}",
                     v.intensity_min, v.chroma_step, v.noise_steps, v.intensity_step, v.area_min_px,
                     v.thickness_min_px, v.smooth, v.relations_max, m.share, m.area, m.position,
                     m.second, m.direction, m.kind, cluster_threshold);
}

}  // namespace aspect
