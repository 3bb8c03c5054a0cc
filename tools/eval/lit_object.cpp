#include "tools/eval/lit_object.h"

#include <Eigen/Geometry>

namespace aspect {
namespace {

constexpr double kAmbient = 0.4;
constexpr double kLeastCosine = 0.3;  // less than that of the corner of a cube that is nearest

// The corners of a cube that is turned, so that no axis of an object is in the middle of three.
std::vector<Eigen::Vector3d> lamp_directions() {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  std::vector<Eigen::Vector3d> directions;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0})
        directions.emplace_back(turn * Eigen::Vector3d(x, y, z).normalized());
  return directions;
}

Scene under_lamp(Scene scene, const Eigen::Vector3d& lamp) {
  for (Surface& surface : scene.surfaces)
    surface.ambient = surface.diffuse = surface.ambient.cwiseProduct(scene.studio.ambient);
  scene.studio.ambient.setConstant(kAmbient);
  Light light;
  light.type = Light::Type::kDirectional;
  light.direction = -lamp;
  light.color.setConstant(1 - kAmbient);
  scene.lights = {light};
  return scene;
}

}  // namespace

Result<LitObject> LitObject::create(const Scene& scene) {
  LitObject object;
  if (scene.lights.empty()) object.lamps_ = lamp_directions();
  for (std::size_t k = 0; k < std::max<std::size_t>(1, object.lamps_.size()); ++k) {
    Result<Renderer> renderer =
        Renderer::create(object.lamps_.empty() ? scene : under_lamp(scene, object.lamps_[k]));
    if (!renderer) return Error{scene.file + ": " + renderer.error()};
    object.renderers_.push_back(std::move(renderer).value());
  }
  return object;
}

const Renderer& LitObject::seen_from(const Eigen::Vector3d& view, Dice& dice) const {
  if (lamps_.empty()) return renderers_.front();
  const std::size_t first = dice.below(lamps_.size());
  for (std::size_t k = 0; k < lamps_.size(); ++k) {
    const std::size_t lamp = (first + k) % lamps_.size();
    if (lamps_[lamp].dot(view) > kLeastCosine) return renderers_[lamp];
  }
  return renderers_[first];
}

}  // namespace aspect
