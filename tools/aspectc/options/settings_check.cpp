#include "tools/aspectc/options/settings_check.h"

#include <fmt/format.h>

namespace aspect {
namespace {

const Option& named(std::string_view table, std::string_view key) {
  const Option* option = find_option(table, key);
  ASPECT_CHECK(option != nullptr);
  return *option;
}

}  // namespace

std::optional<SettingsFault> find_fault(const CompileSettings& settings, const NameOption& name) {
  const CompileOptions& o = settings.options;
  const StudioCameraSettings& c = settings.camera;
  const Option &clusters = named("classes", "cluster_threshold"),
               &patches = named("subdivision", "threshold"), &fx = named("camera", "fx"),
               &fy = named("camera", "fy"), &cx = named("camera", "cx"),
               &cy = named("camera", "cy"), &view = named("camera", "field_of_view_deg"),
               &range = named("camera", "distance");
  if (o.cluster_threshold < o.threshold)
    return SettingsFault{{&clusters, &patches},
                         fmt::format("{} {} is below {} {}; raise it", name(clusters),
                                     o.cluster_threshold, name(patches), o.threshold)};
  if (c.field_of_view_deg && (c.fx_px || c.fy_px || c.cx_px || c.cy_px))
    return SettingsFault{{&view},
                         fmt::format("{} does not go with {}, {}, {} and {}; leave it out",
                                     name(view), name(fx), name(fy), name(cx), name(cy))};
  if (c.fx_px.has_value() != c.fy_px.has_value() || (!c.fx_px && (c.cx_px || c.cy_px)))
    return SettingsFault{{&fx, &fy, &cx, &cy},
                         fmt::format("{} is missing; a principal point needs focal lengths, and "
                                     "they come in pairs",
                                     name(c.fx_px ? fy : fx))};
  if (c.distance && (*c.distance)[0] > (*c.distance)[1])
    return SettingsFault{{&range},
                         fmt::format("{} goes from {} to {}; give the nearest distance first",
                                     name(range), (*c.distance)[0], (*c.distance)[1])};
  return std::nullopt;
}

}  // namespace aspect
