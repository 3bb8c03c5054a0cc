#include "compiler/render/light_samples.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace aspect {
namespace {

using Eigen::Vector3d;

// Nearer to a light there is no direction to it.
constexpr double kLeastDistance = 1e-9;

double share_of_spot(const Light& light, const Vector3d& point) {
  const auto cosine_of = [](double opening_deg) {
    return std::cos(opening_deg / 2 * std::numbers::pi / 180);
  };
  const Vector3d axis = (light.spot->at - light.position).normalized();
  const double cosine = axis.dot((point - light.position).normalized());
  const double inner = cosine_of(light.spot->min_angle_deg);
  const double outer = cosine_of(light.spot->max_angle_deg);
  if (cosine >= inner) return 1;
  return cosine <= outer ? 0 : (cosine - outer) / (inner - outer);
}

void add_point(const Vector3d& position, const Vector3d& color, int falloff, const Vector3d& point,
               std::vector<LightSample>& samples) {
  const Vector3d to_light = position - point;
  const double distance = to_light.norm();
  if (distance < kLeastDistance) return;
  const double divisor = falloff == 0 ? 1 : falloff == 1 ? distance : distance * distance;
  samples.push_back({to_light / distance, distance, color / divisor});
}

}  // namespace

std::vector<LightSample> samples_of(const Light& light, const Vector3d& point_object, double turn) {
  std::vector<LightSample> samples;
  if (light.type == Light::Type::kDirectional) {
    samples.push_back({-light.direction, std::numeric_limits<double>::infinity(), light.color});
    return samples;
  }
  const double share = light.spot ? share_of_spot(light, point_object) : 1;
  if (share == 0) return samples;
  const Vector3d color = share * light.color;
  const Vector3d towards = light.position - point_object;
  if (light.type == Light::Type::kPoint || towards.norm() < kLeastDistance) {
    add_point(light.position, color, light.falloff, point_object, samples);
    return samples;
  }
  const Vector3d u = towards.unitOrthogonal(), v = towards.normalized().cross(u);
  samples.reserve(static_cast<std::size_t>(light.samples));
  for (int k = 0; k < light.samples; ++k) {
    const Eigen::Vector2d disc = light.radius * disc_point(k, light.samples, turn);
    add_point(light.position + disc.x() * u + disc.y() * v, color / light.samples, light.falloff,
              point_object, samples);
  }
  return samples;
}

}  // namespace aspect
