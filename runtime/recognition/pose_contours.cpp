#include "runtime/recognition/pose_contours.h"

#include <algorithm>
#include <optional>

#include "runtime/recognition/seen_colours.h"

namespace aspect {
namespace {

std::optional<Point2d> picture_point(const Vector3d& object_point, const RigidPose& pose,
                                     const CameraModel& camera, const Box& active) {
  const Vector3d p = pose(object_point);
  if (!(p[2] > 0)) return std::nullopt;
  const Point2d bent = camera.bent(
      {camera.cx_px + camera.fx_px * p[0] / p[2], camera.cy_px + camera.fy_px * p[1] / p[2]});
  if (bent.x > active.x - 0.5 && bent.y > active.y - 0.5 &&
      bent.x < active.x + active.width - 0.5 && bent.y < active.y + active.height - 0.5)
    return bent;
  return std::nullopt;
}

std::uint16_t region_at(const Point2d& point, const RegionMap& regions) {
  const auto x = static_cast<std::size_t>(point.x + 0.5),
             y = static_cast<std::size_t>(point.y + 0.5);
  return regions.labels[y * static_cast<std::size_t>(regions.stride_px) + x];
}

// Of an L the centre lies beside it.
bool is_about(const Contour& contour, const Point2d& centre) {
  constexpr double kMostOfWidth = 0.5;
  const double dx = static_cast<double>(contour.centre_px.x) - centre.x,
               dy = static_cast<double>(contour.centre_px.y) - centre.y;
  return dx * dx + dy * dy < kMostOfWidth * kMostOfWidth * static_cast<double>(contour.area_px);
}

}  // namespace

std::size_t contours_at_pose(const ClassIndex& index, std::size_t class_id, const RigidPose& pose,
                             const CameraModel& camera, const RegionMap& regions,
                             std::span<const Contour> contours, std::span<ContourMatch> out) {
  const auto of_class = ClassIndex::part(index.class_contours, index.classes[class_id].contours);
  const auto& colours = index.model.shares;
  std::size_t count = 0;
  const auto is_free = [&](std::size_t contour, std::size_t name) {
    return std::none_of(
        out.begin(), out.begin() + static_cast<std::ptrdiff_t>(count),
        [&](const ContourMatch& match) { return match.contour == contour || match.name == name; });
  };
  const auto name_all = [&](const auto& is_it) {
    for (std::size_t name = 0; name < of_class.size(); ++name) {
      const auto& [x, y, z] = of_class[name].centre_object;
      const auto centre =
          picture_point({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)},
                        pose, camera, regions.active);
      if (!centre) continue;
      for (std::size_t c = 0; c < contours.size() && count < out.size(); ++c) {
        if (!contours[c].external || !is_it(contours[c], *centre) || !is_free(c, name)) continue;
        const std::size_t colour = nearest_share(colours, share_of(contours[c].mean_rgb));
        if (colour < colours.size() && colour == nearest_share(colours, of_class[name].share))
          out[count++] = {static_cast<std::uint16_t>(c), static_cast<std::uint16_t>(name)};
      }
    }
  };
  name_all([&](const Contour& contour, const Point2d& centre) {
    return contour.region == region_at(centre, regions);
  });
  name_all(is_about);
  std::sort(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(count),
            [](const ContourMatch& a, const ContourMatch& b) { return a.name < b.name; });
  return count;
}

}  // namespace aspect
