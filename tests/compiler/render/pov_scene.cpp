#include "tests/compiler/render/pov_scene.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

namespace aspect {
namespace {

using Eigen::Vector3d;

std::string text(const Vector3d& v) {
  return fmt::format("<{:.12f}, {:.12f}, {:.12f}>", v.x(), v.y(), v.z());
}

// POV-Ray multiplies rows by matrices.
std::string text(const Eigen::Affine3d& a) {
  std::string result = "matrix <";
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row)
      result += fmt::format("{}{:.12f}", column + row == 0 ? "" : ", ", a.matrix()(row, column));
  return result + ">";
}

struct ShapeText {
  std::string operator()(const Polygon& polygon) const {
    std::string result = fmt::format("polygon {{ {}", polygon.vertices.size() + 1);
    for (const Vector3d& vertex : polygon.vertices) result += ", " + text(vertex);
    return result + ", " + text(polygon.vertices.front());
  }
  std::string operator()(const SmoothTriangle& triangle) const {
    std::string result = "smooth_triangle { ";
    for (std::size_t k = 0; k < 3; ++k)
      result +=
          (k == 0 ? "" : ", ") + text(triangle.vertices[k]) + ", " + text(triangle.normals[k]);
    return result;
  }
  std::string operator()(const Sphere& sphere) const {
    return fmt::format("sphere {{ {}, {:.12f}", text(sphere.center), sphere.radius);
  }
  std::string operator()(const Ring& ring) const {
    return fmt::format("disc {{ {}, {}, {:.12f}, {:.12f}", text(ring.center), text(ring.normal),
                       ring.max_radius, ring.min_radius);
  }
  std::string operator()(const Cone& cone) const {
    if (cone.base_radius == cone.apex_radius)
      return fmt::format("cylinder {{ {}, {}, {:.12f} open", text(cone.base), text(cone.apex),
                         cone.base_radius);
    return fmt::format("cone {{ {}, {:.12f}, {}, {:.12f} open", text(cone.base), cone.base_radius,
                       text(cone.apex), cone.apex_radius);
  }
  template <typename Other>
  std::string operator()(const Other&) const {
    return "union {";
  }
};

std::string checker_text(const Texture& texture, const Checker& checker, const Vector3d& diffuse) {
  const Eigen::Affine3d object_from_pattern =
      (texture.pattern_from_frame * texture.frame_from_object).inverse();
  return fmt::format("checker rgb {}, rgb {} {}", text(checker.colors[0].cwiseProduct(diffuse)),
                     text(checker.colors[1].cwiseProduct(diffuse)), text(object_from_pattern));
}

std::string map_text(const Texture& texture, const TextureMap& map, const Polygon& rectangle,
                     const std::filesystem::path& file) {
  std::ofstream stream(file, std::ios::binary);
  stream << "P6\n" << map.width_px << ' ' << map.height_px << "\n255\n";
  stream.write(reinterpret_cast<const char*>(map.rgb.data()),
               static_cast<std::streamsize>(map.rgb.size()));
  Eigen::Affine3d object_from_uv = Eigen::Affine3d::Identity();
  const Vector3d u = rectangle.vertices[1] - rectangle.vertices[0];
  const Vector3d v = rectangle.vertices[3] - rectangle.vertices[0];
  object_from_uv.linear() << u, v, u.cross(v).normalized();
  object_from_uv.translation() = rectangle.vertices[0];
  return fmt::format("image_map {{ ppm \"{}\" gamma 1.0 }} {}", file.string(),
                     text(object_from_uv * texture.pattern_from_frame.inverse()));
}

std::string pigment_text(const Scene& scene, const Primitive& primitive, std::size_t number,
                         const std::filesystem::path& folder) {
  const Surface& surface = scene.surfaces[static_cast<std::size_t>(primitive.surface)];
  if (!surface.transparent.isZero(0)) {
    if (scene.studio.exponential_transparency) return "rgbt 1";
    return fmt::format("rgb {} filter 1", text(surface.transparent.cwiseSqrt()));
  }
  if (surface.texture == nullptr)
    return "rgb " + text(surface.diffuse.isZero(0) ? Vector3d::Ones() : surface.diffuse);
  const Texture& texture = *surface.texture;
  if (const auto* checker = std::get_if<Checker>(&texture.pattern))
    return checker_text(texture, *checker, surface.diffuse);
  return map_text(texture, *std::get<ImageMap>(texture.pattern).picture,
                  std::get<Polygon>(primitive.shape), folder / fmt::format("map{}.ppm", number));
}

std::string finish_text(const Scene& scene, const Surface& surface) {
  Vector3d ambient = scene.studio.ambient.cwiseProduct(surface.ambient);
  const bool black = surface.diffuse.isZero(0);
  for (Eigen::Index k = 0; k < 3; ++k)
    if (!black && surface.diffuse[k] > 0) ambient[k] /= surface.diffuse[k];
  std::string result = fmt::format("finish {{ ambient rgb {} diffuse {} reflection {{ rgb {} }}",
                                   text(ambient), black ? 0 : 1, text(surface.specular));
  if (surface.shine > 0)
    result +=
        fmt::format(" phong {:.12f} phong_size {:.12f}", surface.shine_color.x(), surface.shine);
  return result + " }";
}

// POV-Ray's fading by e ^ ((fade_color - 1) length), from fade_power 1000 on.
std::string interior_text(const Scene& scene, const Surface& surface) {
  if (surface.transparent.isZero(0)) return {};
  std::string result = fmt::format(" interior {{ ior {:.12f}", surface.ior);
  if (scene.studio.exponential_transparency) {
    const Vector3d fade_color = 1 + surface.transparent.array().log();
    result += " fade_distance 1 fade_power 1001 fade_color rgb " + text(fade_color);
  }
  return result + " }";
}

// 2 / (1 + (distance / fade_distance) ^ fade_power), far beyond fade_distance.
std::string fading_text(const Light& light, Vector3d& color) {
  if (light.falloff == 0) return {};
  const double near = light.falloff == 1 ? 1e-6 : 1e-4;
  color /= 2 * std::pow(near, light.falloff);
  return fmt::format(" fade_distance {:.9f} fade_power {}", near, light.falloff);
}

std::string light_text(const Light& light) {
  constexpr double kFar = 100;
  Vector3d color = light.color;
  std::string how = fading_text(light, color);
  Vector3d position = light.position;
  if (light.type == Light::Type::kDirectional) {
    position = -kFar * light.direction;
    how += " parallel point_at <0, 0, 0>";
  }
  if (light.type == Light::Type::kSpherical)
    how += fmt::format(
        " area_light <{0:.12f}, 0, 0>, <0, 0, {0:.12f}>, {1}, {1} circular orient "
        "area_illumination",
        2 * light.radius, std::lround(std::sqrt(light.samples)));
  if (light.spot)
    how += fmt::format(" spotlight point_at {} radius {:.12f} falloff {:.12f} tightness 0",
                       text(light.spot->at), light.spot->min_angle_deg / 2,
                       light.spot->max_angle_deg / 2);
  if (!light.casts_shadows) how += " shadowless";
  return fmt::format("light_source {{ {} rgb {}{} }}\n", text(position), text(color), how);
}

// Vectors of any handedness, so that no axis has to change its sign.
std::string camera_text(const Camera& camera) {
  const Intrinsics& in = camera.intrinsics;
  const Eigen::Matrix3d& r = camera.camera_from_object;
  const Vector3d right = r.row(0).transpose() * in.width_px / in.fx_px;
  const Vector3d up = -r.row(1).transpose() * in.height_px / in.fy_px;
  const bool orthogonal = in.projection == Projection::kOrthogonal;
  return fmt::format("camera {{ {} location {} direction {} right {} up {} }}\n",
                     orthogonal ? "orthographic" : "perspective", text(camera.position_object),
                     text(Vector3d(r.row(2).transpose())), text(right), text(up));
}

}  // namespace

std::string pov_scene(const Scene& scene, const Camera& camera,
                      const std::filesystem::path& folder) {
  const Studio& studio = scene.studio;
  std::string result = fmt::format(
      "#version 3.7;\nglobal_settings {{ assumed_gamma 1.0 ambient_light rgb 1 "
      "max_trace_level {} adc_bailout 0.001 }}\nbackground {{ rgb {} }}\n",
      studio.depth + 1, text(studio.background));
  result += camera_text(camera);
  if (studio.haze > 0)
    result += fmt::format("fog {{ fog_type 1 distance {:.12f} rgb {} }}\n",
                          -1 / std::log(1 - studio.haze), text(studio.background));
  for (const Light& light : scene.lights) result += light_text(light);
  for (std::size_t k = 0; k < scene.primitives.size(); ++k) {
    const Primitive& primitive = scene.primitives[k];
    const Surface& surface = scene.surfaces[static_cast<std::size_t>(primitive.surface)];
    result += fmt::format("{} texture {{ pigment {{ {} }} {} }}{}{} }}\n",
                          std::visit(ShapeText{}, primitive.shape),
                          pigment_text(scene, primitive, k, folder), finish_text(scene, surface),
                          interior_text(scene, surface), surface.casts_shadow ? "" : " no_shadow");
  }
  return result;
}

bool povray_is_installed() {
  return std::system("command -v povray >/dev/null 2>&1") == 0;
}

std::optional<PovPicture> pov_picture(const Scene& scene, const Camera& camera,
                                      const std::filesystem::path& folder,
                                      const std::string& options) {
  std::ofstream(folder / "scene.pov") << pov_scene(scene, camera, folder);
  const std::string command = fmt::format(
      "cd '{}' && povray scene.pov +Opicture.png +W{} +H{} -D +FN8 +WT1 File_Gamma=1.0 {} "
      ">povray.log 2>&1",
      folder.string(), camera.intrinsics.width_px, camera.intrinsics.height_px,
      options.empty() ? "-A" : options);
  if (std::system(command.c_str()) != 0) return std::nullopt;
  const cv::Mat bgr = cv::imread((folder / "picture.png").string());
  if (bgr.cols != camera.intrinsics.width_px || bgr.rows != camera.intrinsics.height_px)
    return std::nullopt;
  PovPicture picture{bgr.cols, bgr.rows, {}};
  for (int y = 0; y < bgr.rows; ++y)
    for (int x = 0; x < bgr.cols; ++x)
      for (int channel = 2; channel >= 0; --channel)
        picture.rgb.push_back(bgr.at<cv::Vec3b>(y, x)[channel]);
  return picture;
}

}  // namespace aspect
