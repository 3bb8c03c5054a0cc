#include "compiler/render/ray_shading.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "compiler/render/surface_normal.h"
#include "compiler/render/texture_color.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

// A ray starts off its surface by this share of its coordinates and of its length so far: forty
// times the error of a hit in single precision.
constexpr double kOffset = 4e-6;

// A ray that would change the picture by less than half a step of 8 bits is not followed, and with
// them no more than kMaxRays for one point of the picture: mirrors that face glass double them at
// every step.
constexpr double kLeastWeight = 1.0 / 512;
constexpr int kMaxRays = 4096;

// Surfaces that a shadow ray may cross.
constexpr int kMaxCrossings = 256;

struct NormalAt {
  const Vector3d& point;
  const Vector3d& plane_normal;

  Vector3d operator()(const Sphere& sphere) const { return normal_at(sphere, point); }
  Vector3d operator()(const Ring& ring) const { return normal_at(ring, point); }
  Vector3d operator()(const Cone& cone) const { return normal_at(cone, point); }
  Vector3d operator()(const SmoothTriangle& triangle) const { return normal_at(triangle, point); }
  template <typename Flat>
  Vector3d operator()(const Flat&) const {
    return plane_normal;
  }
};

bool is_round(const Primitive& primitive) {
  return std::holds_alternative<Sphere>(primitive.shape) ||
         std::holds_alternative<Ring>(primitive.shape) ||
         std::holds_alternative<Cone>(primitive.shape);
}

bool is_black(const Vector3d& color) {
  return color.isZero(0);
}

Vector3d reflection(const Vector3d& direction, const Vector3d& normal) {
  return direction - 2 * direction.dot(normal) * normal;
}

// Snell's law for a unit direction against a unit normal that faces it; nothing where all light is
// reflected. `ratio` is the index of refraction before the surface over that behind it.
std::optional<Vector3d> refraction(const Vector3d& direction, const Vector3d& normal,
                                   double ratio) {
  const double cosine = -direction.dot(normal);
  const double inside = 1 - ratio * ratio * (1 - cosine * cosine);
  if (inside < 0) return std::nullopt;
  return ratio * direction + (ratio * cosine - std::sqrt(inside)) * normal;
}

}  // namespace

// A ray's history.
struct RayShading::Path {
  const EmbreeScene* embree = nullptr;
  int* rays_left = nullptr;
  SampleKey key;
  int depth = 0;
  double weight = 1;  // of the ray's colour in the picture
  bool inside = false;
  Vector3d transparent = Vector3d::Zero();  // of the substance, where inside

  Path child(std::uint64_t number, const Vector3d& share) const {
    Path result = *this;
    result.key = key.child(number);
    result.depth = depth + 1;
    result.weight = weight * share.cwiseAbs().maxCoeff();
    return result;
  }
};

struct RayShading::SurfacePoint {
  const Surface* surface = nullptr;
  Vector3d position, direction;  // of the ray
  Vector3d plane_normal;         // unit length, faces the ray
  Vector3d normal;               // that of the shading
  Vector3d fuzzy_normal;
  Vector3d paint;  // the texture's colour
  double offset = 0;

  Vector3d in_front() const { return position + offset * plane_normal; }
  Vector3d behind() const { return position - offset * plane_normal; }
};

bool needs_single_rays(const Scene& scene) {
  const Studio& studio = scene.studio;
  if (studio.antialias != Antialias::kNone || studio.aperture > 0 || studio.haze > 0) return true;
  const bool is_lit = !scene.lights.empty();
  if (is_lit && studio.projection != Projection::kPerspective) return true;
  for (const Light& light : scene.lights)
    if (light.type != Light::Type::kPoint || light.falloff != 0 || light.spot) return true;
  return std::any_of(scene.surfaces.begin(), scene.surfaces.end(), [&](const Surface& surface) {
    if (!is_black(surface.specular) || !is_black(surface.transparent)) return true;
    if (surface.texture != nullptr) return true;
    return is_lit && (surface.shine > 0 || !surface.casts_shadow);
  });
}

RayShading::RayShading(const Scene& scene) : scene_(scene) {
  for (const Surface& surface : scene.surfaces)
    if (!surface.casts_shadow || !is_black(surface.transparent)) shadows_are_plain_ = false;
}

Vector3d RayShading::color(const EmbreeScene& embree, const ViewRay& ray,
                           const SampleKey& key) const {
  int rays_left = kMaxRays;
  Path path;
  path.embree = &embree;
  path.rays_left = &rays_left;
  path.key = key;
  return trace(ray.origin_object, ray.direction_object.normalized(), path);
}

Vector3d RayShading::trace(const Vector3d& origin, const Vector3d& direction,
                           const Path& path) const {
  const Studio& studio = scene_.studio;
  if (path.depth > studio.depth || path.weight < kLeastWeight || --*path.rays_left < 0)
    return Vector3d::Zero();
  const auto hit = path.embree->first_hit(origin, direction);
  if (!hit) {
    if (!path.inside) return studio.background;
    // Out of an open substance without end: what is not black in it lets the background through.
    const bool exponential = studio.exponential_transparency;
    return studio.background.cwiseProduct(fading(path.transparent, exponential ? 0 : 1));
  }
  const SurfacePoint point = point_of(*hit, origin, direction, path);
  const Surface& surface = *point.surface;
  Vector3d color =
      studio.ambient.cwiseProduct(surface.ambient).cwiseProduct(point.paint) + lit(point, path);
  if (!is_black(surface.specular)) color += mirrored(point, path);
  if (!is_black(surface.transparent)) color += refracted(point, path);
  if (path.inside) return color.cwiseProduct(fading(path.transparent, hit->distance));
  if (studio.haze == 0) return color;
  const double clear = std::pow(1 - studio.haze, hit->distance);
  return clear * color + (1 - clear) * studio.background;
}

RayShading::SurfacePoint RayShading::point_of(const EmbreeScene::Hit& hit, const Vector3d& origin,
                                              const Vector3d& direction, const Path& path) const {
  const Primitive& primitive = scene_.primitives[static_cast<std::size_t>(hit.primitive)];
  SurfacePoint point;
  point.surface = &scene_.surfaces[static_cast<std::size_t>(primitive.surface)];
  point.direction = direction;
  point.position = origin + hit.distance * direction;
  point.offset = kOffset * (hit.distance + point.position.cwiseAbs().maxCoeff());
  const Vector3d plane_normal = hit.plane_normal.normalized();
  point.normal = std::visit(NormalAt{point.position, plane_normal}, primitive.shape);
  point.plane_normal = is_round(primitive) ? point.normal : plane_normal;
  if (point.plane_normal.dot(direction) > 0) point.plane_normal = -point.plane_normal;
  if (point.normal.dot(point.plane_normal) < 0) point.normal = -point.normal;
  point.fuzzy_normal = point.normal;
  if (point.surface->fuzz > 0) {
    const Vector3d strayed = point.normal + point.surface->fuzz * path.key.child(3).in_ball();
    // A normal that strayed behind the surface would mirror what is there.
    if (strayed.dot(direction) < 0 && strayed.dot(point.plane_normal) > 0)
      point.fuzzy_normal = strayed.normalized();
  }
  point.paint = Vector3d::Ones();
  if (point.surface->texture != nullptr)
    point.paint = texture_color(*point.surface->texture, primitive, point.position);
  return point;
}

Vector3d RayShading::lit(const SurfacePoint& point, const Path& path) const {
  const Surface& surface = *point.surface;
  const bool shines = surface.shine > 0 && !path.inside && !is_black(surface.shine_color);
  const Vector3d diffuse = surface.diffuse.cwiseProduct(point.paint);
  Vector3d sum = Vector3d::Zero();
  if (!shines && is_black(diffuse)) return sum;
  const Vector3d bounced = reflection(point.direction, point.fuzzy_normal);
  for (std::size_t k = 0; k < scene_.lights.size(); ++k) {
    const double turn = scene_.studio.jitter ? path.key.child(4).number(k) : 0;
    for (const LightSample& light : samples_of(scene_.lights[k], point.position, turn)) {
      const double cosine = point.normal.dot(light.to_light);
      if (cosine <= 0) continue;
      Vector3d share = cosine * diffuse;
      const double along = bounced.dot(light.to_light);
      if (shines && along > 0) share += std::pow(along, surface.shine) * surface.shine_color;
      Vector3d light_color = light.color;
      if (scene_.lights[k].casts_shadows)
        light_color = light_color.cwiseProduct(light_through(point, light, path));
      sum += share.cwiseProduct(light_color);
    }
  }
  return sum;
}

// The share of light that no shadow takes.
Vector3d RayShading::light_through(const SurfacePoint& point, const LightSample& light,
                                   const Path& path) const {
  Vector3d origin = point.in_front();
  double left = light.distance;
  if (shadows_are_plain_)
    return path.embree->is_blocked(origin, light.to_light, left) ? Vector3d::Zero()
                                                                 : Vector3d::Ones();
  Vector3d share = Vector3d::Ones(), transparent = path.transparent;
  bool inside = path.inside;
  double length = 0;  // since the last surface that counts
  for (int crossings = 0; crossings < kMaxCrossings; ++crossings) {
    const auto hit = path.embree->first_hit(origin, light.to_light, left);
    if (!hit) {
      const double way_out = std::isfinite(left) ? length + left : 0;
      return inside ? Vector3d(share.cwiseProduct(fading(transparent, way_out))) : share;
    }
    const Vector3d position = origin + hit->distance * light.to_light;
    const double step = kOffset * (hit->distance + position.cwiseAbs().maxCoeff());
    origin = position + step * light.to_light;
    left -= hit->distance + step;
    length += hit->distance + step;
    const Primitive& primitive = scene_.primitives[static_cast<std::size_t>(hit->primitive)];
    const Surface& surface = scene_.surfaces[static_cast<std::size_t>(primitive.surface)];
    if (surface.casts_shadow) {
      if (inside) share = share.cwiseProduct(fading(transparent, length));
      if (is_black(surface.transparent)) return Vector3d::Zero();
      inside = !inside;
      transparent = surface.transparent;
      length = 0;
    }
    if (left <= 0) return share;
  }
  return Vector3d::Zero();
}

Vector3d RayShading::mirrored(const SurfacePoint& point, const Path& path) const {
  const Vector3d& share = point.surface->specular;
  return share.cwiseProduct(trace(point.in_front(),
                                  reflection(point.direction, point.fuzzy_normal).normalized(),
                                  path.child(1, share)));
}

// Fading is left to the ray inside.
Vector3d RayShading::refracted(const SurfacePoint& point, const Path& path) const {
  const Surface& surface = *point.surface;
  const bool fades_by_length = path.inside || scene_.studio.exponential_transparency;
  Path child = path.child(2, fades_by_length ? Vector3d::Ones().eval() : surface.transparent);
  const double ratio = path.inside ? surface.ior : 1 / surface.ior;
  const auto direction = refraction(point.direction, point.fuzzy_normal, ratio);
  if (!direction)
    return trace(point.in_front(), reflection(point.direction, point.fuzzy_normal).normalized(),
                 child);
  child.inside = !path.inside;
  child.transparent = surface.transparent;
  return trace(point.behind(), direction->normalized(), child);
}

Vector3d RayShading::fading(const Vector3d& transparent, double length) const {
  if (!scene_.studio.exponential_transparency) return transparent;
  return transparent.unaryExpr([length](double part) {
    return part <= 0 ? 0.0 : part >= 1 ? 1.0 : std::pow(part, length);
  });
}

}  // namespace aspect
