#include "compiler/index/index_arrays.h"

#include <algorithm>
#include <numbers>

#include "compiler/index/packing.h"

namespace aspect {
namespace {

namespace fb = ::aspect::schema;

std::int16_t packed_short(float value, double unit) {
  return packed<std::int16_t>(static_cast<double>(value), unit);
}

fb::Direction packed_direction(const Eigen::Vector3d& d) {
  return {packed<std::int16_t>(d.x(), 32767), packed<std::int16_t>(d.y(), 32767),
          packed<std::int16_t>(d.z(), 32767)};
}

fb::KeyContour packed_contour(const ContourFeature& f, std::uint8_t name) {
  const Moments& m = f.moments;
  return {packed_short(f.position.x, 8192),
          packed_short(f.position.y, 8192),
          packed<std::uint16_t>(static_cast<double>(f.area), 65535),
          packed_short(m.xx, 4096),
          packed_short(m.xy, 4096),
          packed_short(m.yy, 4096),
          packed_short(m.xxx, 16384),
          packed_short(m.xxy, 16384),
          packed_short(m.xyy, 16384),
          packed_short(m.yyy, 16384),
          name};
}

void add_contour(const ContourDescription& c, const SourceFromObject& source_from_object,
                 IndexArrays& arrays) {
  const auto share = [&](std::size_t channel) {
    return packed<std::uint8_t>(c.share[channel], 255);
  };
  // 16-bit places and an 8-bit count: what is beyond them is left out.
  std::size_t surface_count = std::min<std::size_t>(c.surfaces.size(), 255);
  if (arrays.surfaces.size() + surface_count > 65535) surface_count = 0;
  const Eigen::Vector3f centre = source_from_object(c.centre_object).cast<float>();
  arrays.contours.emplace_back(
      static_cast<std::uint32_t>(arrays.scores.size()),
      static_cast<std::uint16_t>(c.score_of_type.size()),
      static_cast<std::uint16_t>(surface_count > 0 ? arrays.surfaces.size() : 0),
      static_cast<std::uint8_t>(surface_count), share(0), share(1), share(2), centre.x(),
      centre.y(), centre.z());
  for (const auto& [type, score] : c.score_of_type)
    arrays.scores.emplace_back(static_cast<float>(score), type, std::uint16_t{0});
  arrays.surfaces.insert(arrays.surfaces.end(), c.surfaces.begin(),
                         c.surfaces.begin() + static_cast<std::ptrdiff_t>(surface_count));
}

}  // namespace

IndexArrays pack_arrays(const IndexContents& contents, const IndexSelection& selection) {
  IndexArrays arrays;
  for (std::size_t c = 0; c < selection.class_count; ++c) {
    const Cluster& cluster = contents.clusters[c];
    const ClassDescription& description = contents.classes[c];
    const std::vector<std::size_t> keys =
        choose_key_views(contents.subdivision, cluster, description.typical_view,
                         selection.key_view_spacing_deg * std::numbers::pi / 180);
    const Eigen::Vector3d& typical =
        contents.subdivision.direction(cluster.views[description.typical_view].vertex);
    arrays.classes.emplace_back(
        static_cast<std::uint32_t>(arrays.contours.size()),
        static_cast<std::uint32_t>(cluster.contour_count),
        static_cast<std::uint32_t>(arrays.key_views.size()),
        static_cast<std::uint32_t>(keys.size()), static_cast<float>(cluster.area_fraction),
        static_cast<std::uint32_t>(description.view_count), packed_direction(typical));
    for (const ContourDescription& contour : description.contours)
      add_contour(contour, contents.scene.source_from_object, arrays);
    for (const std::size_t key : keys) {
      const ClusterView& view = cluster.views[key];
      const ObservedView& observed = contents.subdivision.views[number(view.vertex)];
      arrays.key_views.emplace_back(static_cast<std::uint32_t>(arrays.key_contours.size()),
                                    static_cast<std::uint16_t>(cluster.contour_count),
                                    packed_direction(observed.direction));
      for (std::size_t i = 0; i < cluster.contour_count; ++i)
        arrays.key_contours.push_back(packed_contour(observed.contours[i].feature, view.names[i]));
    }
  }
  return arrays;
}

}  // namespace aspect
