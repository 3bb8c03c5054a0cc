#include "tools/calibrate/object/surface_map.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "compiler/render/camera.h"

namespace aspect {
namespace {

Eigen::Vector3d shown_colour(const Scene& scene, const Surface& surface) {
  const Eigen::Vector3d plain = surface.ambient.cwiseProduct(scene.studio.ambient);
  return scene.lights.empty() && plain.maxCoeff() > 0 ? plain : surface.diffuse;
}

Camera camera_of(const PosedFrame& frame) {
  Camera camera;
  camera.intrinsics.width_px = frame.picture.cols;
  camera.intrinsics.height_px = frame.picture.rows;
  camera.intrinsics.fx_px = frame.camera.fx_px;
  camera.intrinsics.fy_px = frame.camera.fy_px;
  camera.intrinsics.cx_px = frame.camera.cx_px;
  camera.intrinsics.cy_px = frame.camera.cy_px;
  const auto rows = frame.camera_from_object.rotation.rows();
  const Vector3d& t = frame.camera_from_object.translation;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      camera.camera_from_object(row, column) =
          rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
  camera.position_object =
      -camera.camera_from_object.transpose() * Eigen::Vector3d(t[0], t[1], t[2]);
  return camera;
}

}  // namespace

Eigen::Vector3d shares_of(const Eigen::Vector3d& colour) {
  const double sum = colour.sum();
  return sum > 0 ? Eigen::Vector3d(colour / sum) : Eigen::Vector3d::Constant(1.0 / 3);
}

std::vector<Paint> paints_of(const Scene& scene, int intensity_min) {
  constexpr double kSame = 1e-6;
  std::vector<bool> used(scene.surfaces.size());
  for (const Primitive& primitive : scene.primitives)
    used[static_cast<std::size_t>(primitive.surface)] = true;
  std::vector<Paint> paints;
  for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
    if (!used[k]) continue;
    const Surface& surface = scene.surfaces[k];
    const Eigen::Vector3d shown = shown_colour(scene, surface);
    const bool textured = surface.texture != nullptr;
    Paint* same = nullptr;
    for (Paint& paint : paints)
      if (!textured && !paint.textured && (paint.shown - shown).cwiseAbs().maxCoeff() < kSame)
        same = &paint;
    if (same == nullptr)
      same = &paints.emplace_back(Paint{{}, shown, textured, 255 * shown.sum() < intensity_min});
    same->surfaces.push_back(static_cast<int>(k));
  }
  return paints;
}

std::vector<int> paint_by_surface(const Scene& scene, const std::vector<Paint>& paints) {
  std::vector<int> places(scene.surfaces.size(), -1);
  for (std::size_t p = 0; p < paints.size(); ++p)
    for (const int surface : paints[p].surfaces)
      places[static_cast<std::size_t>(surface)] = static_cast<int>(p);
  return places;
}

Result<SurfaceMapper> SurfaceMapper::create(const Scene& scene, const std::vector<Paint>& paints) {
  Result<Renderer> renderer = Renderer::create(scene);
  if (!renderer) return Error{scene.file + ": " + renderer.error()};
  const std::vector<int> by_surface = paint_by_surface(scene, paints);
  std::vector<int> by_primitive;
  for (const Primitive& primitive : scene.primitives) {
    const int paint = by_surface[static_cast<std::size_t>(primitive.surface)];
    by_primitive.push_back(paints[static_cast<std::size_t>(paint)].is_background ? -1 : paint);
  }
  return SurfaceMapper(std::move(renderer).value(), std::move(by_primitive));
}

cv::Mat SurfaceMapper::primitives(const PosedFrame& frame) {
  renderer_.render(camera_of(frame), picture_);
  cv::Mat seen(frame.picture.size(), CV_16S, cv::Scalar(0));
  for (int y = 0; y < seen.rows; ++y)
    for (int x = 0; x < seen.cols; ++x) {
      int u = x, v = y;
      if (!frame.camera.is_straight()) {
        const Point2d straight =
            frame.camera.straight({static_cast<double>(x), static_cast<double>(y)});
        u = static_cast<int>(std::lround(straight.x));
        v = static_cast<int>(std::lround(straight.y));
        if (u < 0 || v < 0 || u >= picture_.width_px || v >= picture_.height_px) continue;
      }
      seen.at<std::int16_t>(y, x) = static_cast<std::int16_t>(
          picture_.surface[static_cast<std::size_t>(v * picture_.width_px + u)]);
    }
  return seen;
}

cv::Mat SurfaceMapper::paints(const PosedFrame& frame) {
  cv::Mat seen = primitives(frame);
  for (int y = 0; y < seen.rows; ++y)
    for (int x = 0; x < seen.cols; ++x) {
      auto& value = seen.at<std::int16_t>(y, x);
      value = static_cast<std::int16_t>(
          value == 0 ? -1 : paint_of_primitive_[static_cast<std::size_t>(value - 1)]);
    }
  return seen;
}

cv::Mat distance_to_border(const cv::Mat& paints) {
  cv::Mat inner(paints.size(), CV_8U, cv::Scalar(255));
  for (int y = 0; y < paints.rows; ++y)
    for (int x = 0; x < paints.cols; ++x) {
      const auto here = paints.at<std::int16_t>(y, x);
      if ((x + 1 < paints.cols && paints.at<std::int16_t>(y, x + 1) != here) ||
          (y + 1 < paints.rows && paints.at<std::int16_t>(y + 1, x) != here) ||
          (x > 0 && paints.at<std::int16_t>(y, x - 1) != here) ||
          (y > 0 && paints.at<std::int16_t>(y - 1, x) != here))
        inner.at<std::uint8_t>(y, x) = 0;
    }
  cv::Mat distance;
  cv::distanceTransform(inner, distance, cv::DIST_L2, cv::DIST_MASK_3);
  return distance;
}

}  // namespace aspect
