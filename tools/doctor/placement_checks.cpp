#include "tools/doctor/placement_checks.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "compiler/scene/picture_fit.h"
#include "compiler/scene/scene_extent.h"
#include "tools/aspectc/project/distance_check.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

constexpr std::string_view kGroup = "placement";
constexpr double kOff = 0.05;   // of the radius: more is seen as off centre
constexpr double kLost = 0.25;  // of the radius that fits: less wastes 15 of 16 pixels
constexpr double kLeast_m = 0.002, kMost_m = 5, kUsual_m = 0.15;  // sizes that a camera looks at

struct Unit {
  const char* name;
  double metres;
};
constexpr std::array<Unit, 4> kUnits = {{{"mm", 0.001}, {"m", 1}, {"inch", 0.0254}, {"cm", 0.01}}};

bool is_plausible(double size_m) {
  return size_m >= kLeast_m && size_m <= kMost_m;
}

// The unit in which the size is nearest to that of a thing in the hand; null: none is plausible.
const Unit* likely_unit(double size) {
  const Unit* best = nullptr;
  const auto strangeness = [&](const Unit& unit) {
    return std::abs(std::log(size * unit.metres / kUsual_m));
  };
  for (const Unit& unit : kUnits)
    if (is_plausible(size * unit.metres) &&
        (best == nullptr || strangeness(unit) < strangeness(*best)))
      best = &unit;
  return best;
}

// Without the sign of zero.
std::string words(const Vector3d& with_sign) {
  const Vector3d v = with_sign.array() + 0.0;
  return fmt::format("{:.4g} {:.4g} {:.4g}", v.x(), v.y(), v.z());
}

}  // namespace

double radius_that_fits(const Studio& studio, const WorkingDistance& distance) {
  if (studio.projection == Projection::kOrthogonal) return fitting_radius(studio);
  return fitting_radius_at(studio, distance.near);
}

std::vector<Finding> check_place(const Scene& scene, const WorkingDistance& distance) {
  std::vector<Finding> findings;
  const SceneExtent extent = scene_extent(scene);
  const Vector3d centre = (extent.least + extent.most) / 2;
  const Vector3d off = centre - scene.studio.at;
  const double radius = radius_around(scene, scene.studio.at);
  const double fitting = radius_that_fits(scene.studio, distance);
  if (off.norm() > kOff * radius)
    findings.push_back(
        {kGroup,
         "off_centre",
         Severity::warning,
         fmt::format("its middle {} is {:.3g} off the point {} that the camera looks at, {:.0f} % "
                     "of its radius {:.4g}",
                     words(centre), off.norm(), words(scene.studio.at), 100 * off.norm() / radius,
                     radius),
         fmt::format("translate it by {}; --fix does", words(-off)),
         1,
         {},
         true});
  if (!findings.empty()) {
    findings.back().marks.lines.push_back({scene.studio.at, centre});
    findings.back().marks.points = {scene.studio.at, centre};
  }
  const std::string scaling = fmt::format("scale it by {:.4g}", 0.9 * fitting / radius);
  if (radius > fitting)
    findings.push_back(
        {kGroup,
         "leaves_picture",
         Severity::error,
         fmt::format("it leaves the picture at distance {:g}: its radius is {:.4g}, {:.4g} fits",
                     distance.near, radius, fitting),
         distance.given ? fmt::format("start the range of distances at {:.4g}, or use a wider lens",
                                      distance.near * radius / std::max(fitting, 1e-9))
                        : scaling + "; --fix does",
         1,
         {},
         !distance.given});
  if (radius < kLost * fitting)
    findings.push_back(
        {kGroup,
         "small_in_picture",
         Severity::warning,
         fmt::format("it fills {:.1f} % of the picture's side at distance {:g}: its radius is "
                     "{:.4g}, {:.4g} fits",
                     100 * radius / fitting, distance.near, radius, fitting),
         distance.given ? "bring the camera nearer, or use a longer lens"
                        : scaling + "; --fix does",
         1,
         {},
         !distance.given});
  return findings;
}

std::vector<Finding> check_unit(const ColouredMesh& mesh, bool in_metres) {
  Eigen::AlignedBox3d box;
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) box.extend(mesh.vertices[corner]);
  const Vector3d sizes = box.sizes();
  const double size = sizes.maxCoeff();
  const std::string measured = fmt::format("it measures {} units", words(sizes));
  std::vector<Finding> findings;
  const Unit* likely = likely_unit(size);
  if (likely == nullptr) {
    findings.push_back({kGroup,
                        "wrong_scale",
                        Severity::warning,
                        measured + ", which suits neither mm nor m nor inch",
                        "export it in the unit that it was drawn in",
                        1,
                        {},
                        false});
  } else if (in_metres && !is_plausible(size)) {
    findings.push_back({kGroup,
                        "wrong_scale",
                        Severity::warning,
                        fmt::format("{}, and the format means metres; {} is likelier, {:.4g} m",
                                    measured, likely->name, size * likely->metres),
                        fmt::format("scale it by {:g} when it is exported", likely->metres),
                        1,
                        {},
                        false});
  } else if (!in_metres) {
    findings.push_back(
        {kGroup,
         "unit_unknown",
         Severity::note,
         fmt::format("{}: {:.4g} m if they are mm, {:.4g} m if inches; {} is likeliest", measured,
                     size * 0.001, size * 0.0254, likely->name),
         "nothing to do: it is scaled to the picture, and poses are in the file's units",
         1,
         {},
         false});
  }
  const Vector3d centre = box.center();
  if (centre.norm() > kOff * box.diagonal().norm() / 2)
    findings.push_back({kGroup,
                        "origin_elsewhere",
                        Severity::note,
                        fmt::format("its middle is at {} of the file's coordinates", words(centre)),
                        "nothing to do: it is centred when it is read",
                        1,
                        {},
                        false});
  return findings;
}

}  // namespace aspect
