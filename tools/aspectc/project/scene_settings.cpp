#include "tools/aspectc/project/scene_settings.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/render/camera.h"
#include "compiler/scene/picture_fit.h"

namespace aspect {
namespace {

std::string words_of(const Eigen::Vector3d& v) {
  return fmt::format("{} {} {}", v.x(), v.y(), v.z());
}

// All that settings can change, in words.
std::string words_of(const Scene& scene) {
  const Studio& studio = scene.studio;
  const Intrinsics in = intrinsics_of(studio);
  std::string words = fmt::format("camera {} {} {} {} {} {} distance {} ambient {}", in.width_px,
                                  in.height_px, in.fx_px, in.fy_px, in.cx_px, in.cy_px,
                                  studio.distance, words_of(studio.ambient));
  for (const auto& light : scene.lights)
    words += fmt::format(" light {} {} {}", words_of(light.position), words_of(light.color),
                         light.casts_shadows);
  for (const Surface& surface : scene.surfaces)
    words += fmt::format(" surface {} {}", words_of(surface.diffuse), words_of(surface.ambient));
  return words;
}

void apply_lens(const StudioCameraSettings& camera, Studio& studio) {
  Lens lens;
  lens.fx_px = *camera.fx_px;
  lens.fy_px = *camera.fy_px;
  lens.cx_px = camera.cx_px.value_or((studio.width_px - 1) / 2.0);
  lens.cy_px = camera.cy_px.value_or((studio.height_px - 1) / 2.0);
  studio.lens = lens;
  studio.angle_deg = 360 / std::numbers::pi * std::atan(studio.width_px / (2 * lens.fx_px));
  studio.aspect = lens.fy_px / lens.fx_px * studio.width_px / studio.height_px;
}

bool is_same(const Intrinsics& a, const Intrinsics& b) {
  return a.width_px == b.width_px && a.height_px == b.height_px && a.fx_px == b.fx_px &&
         a.fy_px == b.fy_px && a.cx_px == b.cx_px && a.cy_px == b.cy_px;
}

void apply_camera(const StudioCameraSettings& camera, Studio& studio) {
  const auto shape = [&] { return static_cast<double>(studio.width_px) / studio.height_px; };
  const double shape_before = shape();
  studio.width_px = camera.width_px.value_or(studio.width_px);
  studio.height_px = camera.height_px.value_or(studio.height_px);
  // Pixels keep their shape.
  studio.aspect *= shape() / shape_before;
  studio.angle_deg = camera.field_of_view_deg.value_or(studio.angle_deg);
  if (camera.fx_px) {
    Studio with_lens = studio;
    apply_lens(camera, with_lens);
    if (!is_same(intrinsics_of(with_lens), intrinsics_of(studio))) studio = with_lens;
  }
  if (!camera.distance) return;
  const double near = camera.distance->front(), far = camera.distance->back();
  studio.distance = near == far ? near : std::sqrt(near * far);
}

void apply_light(const LightSettings& light, Scene& scene) {
  if (light.ambient) scene.studio.ambient = Eigen::Vector3d(light.ambient->data());
  if (light.lamps.empty()) return;
  scene.lights.clear();
  for (const LampSettings& lamp : light.lamps) {
    auto& added = scene.lights.emplace_back();
    added.position = lamp.position;
    added.color = lamp.colour;
    added.casts_shadows = lamp.shadows;
  }
}

// Of the same text: colours of files are written with few digits.
bool is_colour(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  constexpr double kSame = 1e-6;
  return (a - b).cwiseAbs().maxCoeff() <= kSame;
}

// Colours are looked up in the scene as it was read, so that two surfaces can change places.
Result<Done> apply_surface(const SurfaceSettings& wanted, const std::vector<Surface>& as_read,
                           std::vector<Surface>& surfaces) {
  if (wanted.index && static_cast<std::size_t>(*wanted.index) >= surfaces.size())
    return Error{fmt::format("{}: [[surface]] index is {}; the scene has surfaces 0 to {}",
                             wanted.place, *wanted.index,
                             static_cast<std::ptrdiff_t>(surfaces.size()) - 1)};
  std::size_t meant = 0;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const bool means = wanted.index ? static_cast<std::size_t>(*wanted.index) == i
                                    : is_colour(as_read[i].diffuse, *wanted.colour);
    if (!means) continue;
    ++meant;
    surfaces[i].diffuse = wanted.diffuse.value_or(surfaces[i].diffuse);
    surfaces[i].ambient = wanted.ambient.value_or(
        wanted.diffuse && as_read[i].ambient == as_read[i].diffuse ? *wanted.diffuse
                                                                   : surfaces[i].ambient);
  }
  if (meant > 0) return Done{};
  std::vector<std::string> colours;
  constexpr std::size_t kMostShown = 8;
  for (std::size_t i = 0; i < std::min(as_read.size(), kMostShown); ++i)
    colours.push_back(fmt::format("[{}, {}, {}]", as_read[i].diffuse.x(), as_read[i].diffuse.y(),
                                  as_read[i].diffuse.z()));
  return Error{fmt::format("{}: [[surface]] colour is that of no surface; there are {}{}",
                           wanted.place, fmt::join(colours, ", "),
                           as_read.size() > kMostShown ? " and more" : "")};
}

}  // namespace

Result<Done> apply_settings(const CompileSettings& settings, Scene& scene) {
  const std::string before = words_of(scene);
  const Studio studio_before = scene.studio;
  apply_camera(settings.camera, scene.studio);
  apply_light(settings.light, scene);
  const std::vector<Surface> as_read = scene.surfaces;
  for (const SurfaceSettings& surface : settings.surfaces)
    if (auto done = apply_surface(surface, as_read, scene.surfaces); !done) return done;
  const std::string after = words_of(scene);
  if (after != before) scene.source += "\nproject " + after;
  const bool camera_changed = !is_same(intrinsics_of(studio_before), intrinsics_of(scene.studio)) ||
                              studio_before.distance != scene.studio.distance;
  if (camera_changed)
    std::erase_if(scene.warnings, [](const std::string& warning) {
      return warning.find(kLeavesPicture) != std::string::npos;
    });
  return Done{};
}

StudioCameraSettings studio_camera_of(const Studio& studio) {
  const Intrinsics in = intrinsics_of(studio);
  StudioCameraSettings camera;
  camera.width_px = in.width_px;
  camera.height_px = in.height_px;
  camera.field_of_view_deg = studio.angle_deg;
  camera.fx_px = in.fx_px;
  camera.fy_px = in.fy_px;
  camera.cx_px = in.cx_px;
  camera.cy_px = in.cy_px;
  camera.distance = {studio.distance, studio.distance};
  return camera;
}

}  // namespace aspect
