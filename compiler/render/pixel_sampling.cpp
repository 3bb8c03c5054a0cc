#include "compiler/render/pixel_sampling.h"

#include <algorithm>
#include <cmath>

#include "compiler/render/shading.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

constexpr std::int64_t kPixel = 16;  // points a side
constexpr int kLensSamples = 8;
constexpr int kMostPieces = 64;

// A jittered sample moves by up to this share of the distance to its neighbours.
constexpr double kJitter = 0.25;

// Of the points around it among which this one is sampled first: it depends on its place alone, so
// that pixels agree about the corners they share.
double spacing_px(std::int64_t x, std::int64_t y) {
  std::int64_t step = 1;
  while (step < kPixel && ((x | y) & step) == 0) step *= 2;
  return static_cast<double>(step) / kPixel;
}

Vector3d mean(const std::array<Vector3d, 4>& colors) {
  return (colors[0] + colors[1] + colors[2] + colors[3]) / 4;
}

double greatest_difference(const std::array<Vector3d, 4>& colors) {
  Vector3d least = colors[0], most = colors[0];
  for (const Vector3d& color : colors) {
    least = least.cwiseMin(color);
    most = most.cwiseMax(color);
  }
  return (most - least).maxCoeff();
}

// What a pixel and its eight neighbours show.
class Neighbourhood {
 public:
  Neighbourhood(const Picture& picture, int x, int y) {
    const auto id = [&](int column, int row) {
      return picture
          .surface[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width_px) +
                   static_cast<std::size_t>(column)];
    };
    for (int row = std::max(y - 1, 0); row <= std::min(y + 1, picture.height_px - 1); ++row)
      for (int column = std::max(x - 1, 0); column <= std::min(x + 1, picture.width_px - 1);
           ++column)
        ids_[count_++] = id(column, row);
  }

  bool is_border() const {
    return std::any_of(ids_.data(), ids_.data() + count_,
                       [&](std::uint16_t id) { return id != ids_[0]; });
  }
  bool all(const std::vector<std::uint8_t>& flag_by_id) const {
    return std::all_of(ids_.data(), ids_.data() + count_,
                       [&](std::uint16_t id) { return flag_by_id[id] != 0; });
  }

 private:
  std::array<std::uint16_t, 9> ids_{};
  std::size_t count_ = 0;
};

}  // namespace

PixelSampling::PixelSampling(const RayShading& shading, const EmbreeScene& embree,
                             const Camera& camera)
    : shading_(shading), embree_(embree), camera_(camera), studio_(shading.studio()) {
  if (studio_.aperture > 0) {
    lens_samples_ = studio_.samples > 0 ? studio_.samples : kLensSamples;
    const Vector3d forward = camera.camera_from_object.row(2).transpose();
    focal_depth_ = studio_.focal_length > 0 ? studio_.focal_length
                                            : forward.dot(studio_.at - camera.position_object);
  }
  const int pieces = studio_.samples > 0 ? std::min(studio_.samples, kMostPieces) : kMostPieces;
  least_side_ = kPixel;
  for (int more = 4; more <= pieces; more *= 4) least_side_ /= 2;
}

// Every ray through the lens meets the others at the focal depth.
Vector3d PixelSampling::sample(const Point& point, bool may_move) const {
  const SampleKey key(point.x, point.y);
  double x_px = static_cast<double>(point.x) / kPixel - 0.5;
  double y_px = static_cast<double>(point.y) / kPixel - 0.5;
  if (may_move && studio_.jitter) {
    const double reach = kJitter * spacing_px(point.x, point.y);
    x_px += reach * (2 * key.child(0).number(0) - 1);
    y_px += reach * (2 * key.child(0).number(1) - 1);
  }
  const ViewRay ray = view_ray(camera_, x_px, y_px);
  const auto cut_off = [](const Vector3d& color) { return color.cwiseMax(0).cwiseMin(1).eval(); };
  if (studio_.aperture == 0) return cut_off(shading_.color(embree_, ray, key.child(1)));

  const Vector3d focus = ray.origin_object + focal_depth_ * ray.direction_object;
  const double turn = studio_.jitter ? key.child(2).number(0) : 0;
  Vector3d sum = Vector3d::Zero();
  for (int k = 0; k < lens_samples_; ++k) {
    const Eigen::Vector2d disc = studio_.aperture * disc_point(k, lens_samples_, turn);
    const Vector3d start = ray.origin_object +
                           camera_.camera_from_object.transpose() * Vector3d(disc.x(), disc.y(), 0);
    const SampleKey own = key.child(3 + static_cast<std::uint64_t>(k));
    sum += cut_off(shading_.color(embree_, {start, focus - start}, own));
  }
  return sum / lens_samples_;
}

Vector3d PixelSampling::split(const Point& least, std::int64_t side, const Corners& corners) const {
  if (side <= least_side_ || 255 * greatest_difference(corners) <= studio_.threshold)
    return mean(corners);
  const std::int64_t half = side / 2;
  const auto at = [&](std::int64_t x, std::int64_t y) {
    return sample({least.x + x, least.y + y}, true);
  };
  const Vector3d top = at(half, 0), left = at(0, half), middle = at(half, half);
  const Vector3d right = at(side, half), bottom = at(half, side);
  const Vector3d a = split(least, half, {corners[0], top, left, middle});
  const Vector3d b = split({least.x + half, least.y}, half, {top, corners[1], middle, right});
  const Vector3d c = split({least.x, least.y + half}, half, {left, middle, corners[2], bottom});
  const Vector3d d =
      split({least.x + half, least.y + half}, half, {middle, right, bottom, corners[3]});
  return (a + b + c + d) / 4;
}

// `corners` is null where the pixel shows its centre.
Vector3d PixelSampling::pixel(int x, int y, bool is_border, const Corners* corners) const {
  const Point least{kPixel * x, kPixel * y};
  const Point centre{least.x + kPixel / 2, least.y + kPixel / 2};
  if (corners != nullptr)
    return studio_.antialias == Antialias::kAdaptive ? split(least, kPixel, *corners)
                                                     : mean(*corners);
  if (studio_.antialias != Antialias::kQuick || !is_border) return sample(centre, false);
  return mean({sample(least, true), sample({least.x + kPixel, least.y}, true),
               sample({least.x, least.y + kPixel}, true),
               sample({least.x + kPixel, least.y + kPixel}, true)});
}

void PixelSampling::sample_row_of_corners(int row, std::vector<Vector3d>& corners) const {
  for (std::size_t column = 0; column < corners.size(); ++column)
    corners[column] = sample({kPixel * static_cast<std::int64_t>(column), kPixel * row}, true);
}

void PixelSampling::color(const std::vector<std::uint8_t>& no_antialias_by_surface,
                          Picture& picture) {
  const bool needs_corners =
      studio_.antialias == Antialias::kCorners || studio_.antialias == Antialias::kAdaptive;
  const bool background_may_change = studio_.antialias != Antialias::kNone || studio_.aperture > 0;
  const auto width = static_cast<std::size_t>(picture.width_px);
  std::vector<Vector3d> above(needs_corners ? width + 1 : 0), below(above);
  sample_row_of_corners(0, below);
  for (int y = 0; y < picture.height_px; ++y) {
    above.swap(below);
    sample_row_of_corners(y + 1, below);
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t k = static_cast<std::size_t>(y) * width + x;
      if (picture.surface[k] == 0 && !background_may_change) continue;
      const Neighbourhood around(picture, static_cast<int>(x), y);
      const bool keep_whole = around.all(no_antialias_by_surface);
      Corners corners;
      if (needs_corners) corners = {above[x], above[x + 1], below[x], below[x + 1]};
      const Rgb rgb = to_8_bit(pixel(static_cast<int>(x), y, around.is_border() && !keep_whole,
                                     needs_corners && !keep_whole ? &corners : nullptr));
      std::copy(rgb.begin(), rgb.end(), &picture.rgb[3 * k]);
    }
  }
}

}  // namespace aspect
