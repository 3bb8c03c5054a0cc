// A plane seen by a pinhole camera has a disparity (1 / depth) that is linear over the picture, so
// that a straight line through disparities finds planes exactly, whatever their slant.
// Steps: fit a plane to the 5 x 5 window about every pixel, which averages noise and quantisation
// away; let every pixel take the plane of the nine windows about it that fits best, so that normals
// change at once where surfaces meet, and not over the width of a window (Kuwahara et al. 1976,
// for planes in place of means); forbid cores at either side of a gap between depths.
// The code of a plane is Lambert's azimuthal projection of its normal, about evenly spread over
// angles, and its distance from the middle of what is seen.
// Weak side: surfaces bent more than normal_step_deg over two pixels fall apart.
#include "runtime/vision/range_codes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "runtime/base/portable_math.h"

namespace aspect {
namespace {

constexpr int kReach_px = 2;                             // windows of 5 x 5
constexpr float kWindowPixels = 25, kWindowSpread = 50;  // sums of 1 and of dx^2 over a window
constexpr float kUnfit = std::numeric_limits<float>::infinity();

// Another window is taken only where it fits so much better: of windows that differ by noise alone
// the pixel's own has the truest normal.
constexpr float kClearlyBetter = 0.5F;

constexpr float kCodeZero = 128, kTiltScale = 120;
// A unit is as far as the outline's pixels are on average; at the outline a plane turned by an
// angle then moves by about what its tilt does.
constexpr float kPlaceScale = 48;

std::uint8_t code_of(float value) {
  return static_cast<std::uint8_t>(std::clamp(value + kCodeZero + 0.5F, 0.0F, 255.0F));
}

}  // namespace

struct RangeCodes::RowSums {
  float *sum, *x, *y, *squares, *least;
};

RangeCamera range_camera(int width_px, int height_px, float field_of_view_deg) {
  const double half_rad = static_cast<double>(field_of_view_deg) * std::numbers::pi / 360;
  return {static_cast<float>(width_px / 2.0 / portable_tan(half_rad)),
          static_cast<float>(width_px - 1) / 2, static_cast<float>(height_px - 1) / 2};
}

std::uint8_t code_step(float normal_step_deg) {
  // Lambert's projection takes an angle to sqrt(2) sin(angle / 2).
  const double half_rad = static_cast<double>(normal_step_deg) * std::numbers::pi / 360;
  const double step =
      static_cast<double>(kTiltScale) * std::numbers::sqrt2 * portable_sin(half_rad);
  return static_cast<std::uint8_t>(std::clamp(step, 1.0, 255.0));
}

void RangeCodes::take(Arena& arena, int width_px, int height_px) {
  const auto width = static_cast<std::size_t>(width_px);
  const std::size_t pixels = width * static_cast<std::size_t>(height_px);
  disparity_ = arena.take<float>(pixels);
  misfit_ = arena.take<float>(pixels);
  tilt_x_ = arena.take<std::uint8_t>(pixels);
  tilt_y_ = arena.take<std::uint8_t>(pixels);
  at_ = arena.take<std::uint8_t>(pixels);
  sums_ = arena.take<float>(5 * width);
  stride_px_ = width_px;
}

bool RangeCodes::run(const Frame& frame, const VisionParameters& parameters, Planes& codes,
                     CodeMasks& masks) noexcept {
  const RangeParameters& range = parameters.range;
  active_ = box_of_numbers(frame, parameters, std::max(range.steps_min, 1),
                           std::min(range.steps_max, 65534));
  codes.active = active_;
  if (active_.empty()) return false;
  camera_ = range_camera(frame.width_px, frame.height_px, range.field_of_view_deg);
  read_disparities(frame, range, masks);
  find_reference();
  const float most = range.depth_step / 2;
  for (int y = active_.y; y < active_.y + active_.height; ++y)
    fit_row(y, kWindowPixels * most * most);
  choose_windows(codes, masks);
  mark_jumps(range.depth_step, masks);
  spread_codes(range.depth_step, codes, masks);
  return true;
}

void RangeCodes::read_disparities(const Frame& frame, const RangeParameters& range,
                                  CodeMasks& masks) {
  const int least = std::max(range.steps_min, 1), most = std::min(range.steps_max, 65534);
  for (int y = active_.y; y < active_.y + active_.height; ++y) {
    for (int x = active_.x; x < active_.x + active_.width; ++x) {
      const int depth = number_at(frame, x, y);
      const bool measured = depth >= least && depth <= most;
      disparity_[place(x, y)] = measured ? 1.0F / static_cast<float>(depth) : 0.0F;
      masks.foreground[place(x, y)] = measured ? 255 : 0;
    }
  }
}

void RangeCodes::find_reference() {
  double count = 0, squares = 0;
  std::array<double, 3> sum{};
  for (int y = active_.y; y < active_.y + active_.height; ++y) {
    const double v = static_cast<double>((static_cast<float>(y) - camera_.centre_y_px)) /
                     static_cast<double>(camera_.focal_px);
    for (int x = active_.x; x < active_.x + active_.width; ++x) {
      const auto disparity = static_cast<double>(disparity_[place(x, y)]);
      if (disparity <= 0) continue;
      const double u = static_cast<double>((static_cast<float>(x) - camera_.centre_x_px)) /
                       static_cast<double>(camera_.focal_px);
      const double depth = 1 / disparity;
      sum[0] += u * depth;
      sum[1] += v * depth;
      sum[2] += depth;
      squares += (u * u + v * v + 1) * depth * depth;
      count += 1;
    }
  }
  double spread = squares / count;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double mean = sum[axis] / count;
    reference_.centre[axis] = static_cast<float>(mean);
    spread -= mean * mean;
  }
  reference_.size = static_cast<float>(std::sqrt(std::max(spread, 1.0)));
}

// Sums over the window about every pixel of a row, of differences to the pixel itself: those of
// disparities would cancel. Rows that alias nothing let compilers make vector code of this.
void RangeCodes::add_window_rows(int y, const RowSums& sums) const {
  const int count = active_.width - 2 * kReach_px;
  const float* __restrict centre = disparity_.data() + place(active_.x + kReach_px, y);
  float* __restrict sum = sums.sum;
  float* __restrict sum_x = sums.x;
  float* __restrict sum_y = sums.y;
  float* __restrict squares = sums.squares;
  float* __restrict least = sums.least;
  for (float* row : {sum, sum_x, sum_y, squares}) std::fill_n(row, count, 0.0F);
  std::copy_n(centre, count, least);
  for (int dy = -kReach_px; dy <= kReach_px; ++dy) {
    const float* __restrict row = disparity_.data() + place(active_.x, y + dy);
    const auto down = static_cast<float>(dy);
    for (int i = 0; i < count; ++i) {
      const float a = row[i] - centre[i], b = row[i + 1] - centre[i], c = row[i + 2] - centre[i];
      const float d = row[i + 3] - centre[i], e = row[i + 4] - centre[i];
      const float total = a + b + c + d + e;
      sum[i] += total;
      sum_x[i] += 2 * (e - a) + (d - b);
      sum_y[i] += down * total;
      squares[i] += a * a + b * b + c * c + d * d + e * e;
      least[i] = std::min({least[i], row[i], row[i + 1], row[i + 2], row[i + 3], row[i + 4]});
    }
  }
}

void RangeCodes::fit_row(int y, float most_misfit) {
  const auto width = static_cast<std::size_t>(stride_px_);
  float* misfit = misfit_.data() + place(active_.x, y);
  std::fill_n(misfit, active_.width, kUnfit);
  const bool inside = y >= active_.y + kReach_px && y < active_.y + active_.height - kReach_px;
  if (!inside || active_.width <= 2 * kReach_px) return;
  const RowSums sums = {sums_.data(), sums_.data() + width, sums_.data() + 2 * width,
                        sums_.data() + 3 * width, sums_.data() + 4 * width};
  add_window_rows(y, sums);
  for (int i = 0; i < active_.width - 2 * kReach_px; ++i) {
    if (sums.least[i] <= 0) continue;
    const float centre = disparity_[place(active_.x + kReach_px + i, y)];
    const float mean = sums.sum[i] / kWindowPixels;
    const float left = sums.squares[i] - sums.sum[i] * mean -
                       (sums.x[i] * sums.x[i] + sums.y[i] * sums.y[i]) / kWindowSpread;
    const float relative = std::max(left, 0.0F) / (centre * centre);
    if (relative > most_misfit) continue;
    misfit[i + kReach_px] = relative;
    encode(active_.x + kReach_px + i, y, sums, static_cast<std::size_t>(i), centre + mean);
  }
}

// With disparity = (a, b, c) . ray on a plane, (a, b, c) is its normal over its distance.
void RangeCodes::encode(int x, int y, const RowSums& sums, std::size_t column, float mean) {
  const float gradient_x = sums.x[column] / kWindowSpread;
  const float gradient_y = sums.y[column] / kWindowSpread;
  const float a = camera_.focal_px * gradient_x, b = camera_.focal_px * gradient_y;
  const float c = mean - (static_cast<float>(x) - camera_.centre_x_px) * gradient_x -
                  (static_cast<float>(y) - camera_.centre_y_px) * gradient_y;
  const float distance = 1 / std::sqrt(a * a + b * b + c * c);
  const std::array<float, 3> normal = {a * distance, b * distance, c * distance};
  constexpr float kLeast = 0.05F;  // keeps what looks away from the camera finite
  const float tilt = kTiltScale / std::sqrt(std::max(1 + normal[2], kLeast));
  const std::array<float, 3>& from = reference_.centre;
  const float beyond = distance - (normal[0] * from[0] + normal[1] * from[1] + normal[2] * from[2]);
  tilt_x_[place(x, y)] = code_of(tilt * normal[0]);
  tilt_y_[place(x, y)] = code_of(tilt * normal[1]);
  at_[place(x, y)] = code_of(kPlaceScale * beyond / reference_.size);
}

// Of the nine windows at most kReach_px away, all of which hold the pixel.
std::size_t RangeCodes::best_window(int x, int y) const {
  const int x_end = active_.x + active_.width, y_end = active_.y + active_.height;
  std::size_t best = place(x, y);
  float least = misfit_[best] * kClearlyBetter;
  for (int v = y - kReach_px; v <= y + kReach_px; v += kReach_px) {
    if (v < active_.y || v >= y_end) continue;
    for (int u = x - kReach_px; u <= x + kReach_px; u += kReach_px) {
      if (u < active_.x || u >= x_end || misfit_[place(u, v)] >= least) continue;
      best = place(u, v);
      least = misfit_[best];
    }
  }
  return best;
}

void RangeCodes::choose_windows(Planes& codes, CodeMasks& masks) const {
  const int x_end = active_.x + active_.width, y_end = active_.y + active_.height;
  for (int y = active_.y; y < y_end; ++y) {
    for (int x = active_.x; x < x_end; ++x) {
      const std::size_t i = place(x, y);
      masks.solid[i] = 0;
      codes.red[i] = codes.green[i] = codes.blue[i] = 0;
      if (masks.foreground[i] == 0) continue;
      const std::size_t best = best_window(x, y);
      if (misfit_[best] == kUnfit) continue;
      masks.solid[i] = 255;
      codes.red[i] = tilt_x_[best];
      codes.green[i] = tilt_y_[best];
      codes.blue[i] = at_[best];
    }
  }
}

// Whether the depths of the pixels i and i + step belong to two surfaces: neither lies near the
// other, nor where the line through the other and the pixel behind it leads.
bool RangeCodes::jumps(std::ptrdiff_t i, std::ptrdiff_t step, bool has_before, bool has_after,
                       float depth_step) const {
  const float* at = disparity_.data() + i;
  const float here = at[0], next = at[step];
  if (here <= 0 || next <= 0) return false;
  const float most = depth_step * std::min(here, next);
  if (std::abs(next - here) <= most) return false;
  if (has_before && at[-step] > 0 && std::abs(2 * here - at[-step] - next) <= most) return false;
  return !(has_after && at[2 * step] > 0 && std::abs(2 * next - at[2 * step] - here) <= most);
}

void RangeCodes::mark_jumps(float depth_step, CodeMasks& masks) const {
  const int x_end = active_.x + active_.width, y_end = active_.y + active_.height;
  for (int y = active_.y; y < y_end; ++y) {
    for (int x = active_.x; x < x_end; ++x) {
      const auto i = static_cast<std::ptrdiff_t>(place(x, y));
      std::uint8_t* solid = masks.solid.data() + i;
      if (x + 1 < x_end && jumps(i, 1, x > active_.x, x + 2 < x_end, depth_step))
        solid[0] = solid[1] = 0;
      if (y + 1 < y_end && jumps(i, stride_px_, y > active_.y, y + 2 < y_end, depth_step))
        solid[0] = solid[stride_px_] = 0;
    }
  }
}

// Tips that no window fits into take the code of the pixel beside them, from left and top, then
// from right and bottom. Cores they never are.
void RangeCodes::spread_codes(float depth_step, Planes& codes, const CodeMasks& masks) const {
  const auto bare = [&](std::size_t i) {
    return masks.foreground[i] != 0 && codes.red[i] == 0 && codes.green[i] == 0;
  };
  const auto copy = [&](std::size_t from, std::size_t to) {
    if (!bare(to) || masks.foreground[from] == 0) return;
    const float a = disparity_[from], b = disparity_[to];
    if (std::abs(a - b) > depth_step * std::min(a, b)) return;
    codes.red[to] = codes.red[from];
    codes.green[to] = codes.green[from];
    codes.blue[to] = codes.blue[from];
  };
  const int x_end = active_.x + active_.width, y_end = active_.y + active_.height;
  for (int y = active_.y; y < y_end; ++y) {
    for (int x = active_.x; x < x_end; ++x) {
      if (x > active_.x) copy(place(x - 1, y), place(x, y));
      if (y > active_.y) copy(place(x, y - 1), place(x, y));
    }
  }
  for (int y = y_end - 1; y >= active_.y; --y) {
    for (int x = x_end - 1; x >= active_.x; --x) {
      if (x + 1 < x_end) copy(place(x + 1, y), place(x, y));
      if (y + 1 < y_end) copy(place(x, y + 1), place(x, y));
    }
  }
}

}  // namespace aspect
