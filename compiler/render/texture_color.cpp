#include "compiler/render/texture_color.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/render/surface_normal.h"
#include "compiler/scene/ear_clipping.h"

namespace aspect {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// A face in the border of two cubes belongs to the upper one in spite of rounding.
constexpr double kBorder = 1e-5;

double turns(double y, double x) {
  const double share = std::atan2(y, x) / (2 * std::numbers::pi);
  return share < 0 ? share + 1 : share;
}

struct MapPosition {
  const Texture& texture;
  const Vector3d& point;

  // At right angles to the axis, the frame's x axis or what is left of it.
  Vector3d start_direction(const Vector3d& axis) const {
    constexpr double kNearlyAlong = 0.99;
    const Eigen::Matrix3d frame_from_object = texture.frame_from_object.linear();
    const Eigen::Matrix3d object_from_frame = frame_from_object.inverse();
    Vector3d start = object_from_frame.col(0).normalized();
    if (std::abs(start.dot(axis)) > kNearlyAlong) start = object_from_frame.col(1).normalized();
    return (start - start.dot(axis) * axis).normalized();
  }

  Vector2d operator()(const Polygon& polygon) const {
    const auto& vertices = polygon.vertices;
    const Vector3d normal = polygon_normal(vertices);
    std::size_t end = 1;  // vertices may repeat
    while (end + 1 < vertices.size() && vertices[end] == vertices[0]) ++end;
    const Vector3d u = (vertices[end] - vertices[0]).normalized(), v = normal.cross(u);
    Vector2d least = Vector2d::Zero(), greatest = Vector2d::Zero();
    const auto position = [&](const Vector3d& p) {
      return Vector2d(u.dot(p - vertices[0]), v.dot(p - vertices[0]));
    };
    for (const Vector3d& vertex : vertices) {
      least = least.cwiseMin(position(vertex));
      greatest = greatest.cwiseMax(position(vertex));
    }
    return (position(point) - least).cwiseQuotient(greatest - least);
  }

  Vector2d operator()(const SmoothTriangle& triangle) const {
    return weights_at(triangle, point).tail<2>();
  }

  Vector2d operator()(const Sphere& sphere) const {
    const Vector3d d = (texture.frame_from_object.linear() * (point - sphere.center)).normalized();
    return {turns(d.y(), d.x()), std::asin(std::clamp(d.z(), -1.0, 1.0)) / std::numbers::pi + 0.5};
  }

  Vector2d operator()(const Ring& ring) const {
    const Vector3d u = start_direction(ring.normal), v = ring.normal.cross(u);
    const Vector3d d = (point - ring.center) / (2 * ring.max_radius);
    return {u.dot(d) + 0.5, v.dot(d) + 0.5};
  }

  Vector2d operator()(const Cone& cone) const {
    const double length = (cone.apex - cone.base).norm();
    const Vector3d axis = (cone.apex - cone.base) / length;
    const Vector3d u = start_direction(axis), v = axis.cross(u), d = point - cone.base;
    return {turns(v.dot(d), u.dot(d)), axis.dot(d) / length};
  }

  template <typename Other>
  Vector2d operator()(const Other&) const {
    return (texture.frame_from_object * point).head<2>();
  }
};

struct ColorAt {
  const Texture& texture;
  const Primitive& primitive;
  const Vector3d& point;

  Vector3d operator()(const Checker& checker) const {
    const Vector3d cell = texture.pattern_from_frame * (texture.frame_from_object * point) +
                          Vector3d::Constant(kBorder);
    const double sum = std::floor(cell.x()) + std::floor(cell.y()) + std::floor(cell.z());
    return checker.colors[std::fmod(sum, 2) == 0 ? 0 : 1];
  }

  Vector3d operator()(const ImageMap& map) const {
    const Vector2d uv = map_position(primitive, texture, point);
    const Vector3d at = texture.pattern_from_frame * Vector3d(uv.x(), uv.y(), 0);
    const TextureMap& picture = *map.picture;
    const auto texel = [](double share, int count) {
      const double inside = std::isfinite(share) ? share - std::floor(share) : 0;
      return std::min(static_cast<int>(inside * count), count - 1);
    };
    const int column = texel(at.x(), picture.width_px);
    const int row = picture.height_px - 1 - texel(at.y(), picture.height_px);
    const std::uint8_t* rgb =
        &picture
             .rgb[3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width_px) +
                       static_cast<std::size_t>(column))];
    return Vector3d(rgb[0], rgb[1], rgb[2]) / 255;
  }
};

}  // namespace

Vector2d map_position(const Primitive& primitive, const Texture& texture,
                      const Vector3d& point_object) {
  return std::visit(MapPosition{texture, point_object}, primitive.shape);
}

Vector3d texture_color(const Texture& texture, const Primitive& primitive,
                       const Vector3d& point_object) {
  return std::visit(ColorAt{texture, primitive, point_object}, texture.pattern);
}

}  // namespace aspect
