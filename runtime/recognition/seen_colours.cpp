#include "runtime/recognition/seen_colours.h"

#include <algorithm>
#include <cmath>

namespace aspect {
namespace {

// Largest distance between shares that still names a colour.
constexpr float kFarthestShare = 0.12F;

bool holds(const Box& box, int x, int y) {
  return x >= box.x && y >= box.y && x < box.x + box.width && y < box.y + box.height;
}

}  // namespace

float squared_distance(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  float sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

std::array<float, 3> share_of(const std::array<float, 3>& rgb) {
  const float sum = std::max(1.0F, rgb[0] + rgb[1] + rgb[2]);
  return {rgb[0] / sum, rgb[1] / sum, rgb[2] / sum};
}

std::size_t nearest_share(std::span<const std::array<float, 3>> shares,
                          const std::array<float, 3>& share) {
  std::size_t nearest = shares.size();
  float least = kFarthestShare * kFarthestShare;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    const float distance = squared_distance(share, shares[k]);
    if (distance >= least) continue;
    least = distance;
    nearest = k;
  }
  return nearest;
}

std::array<float, 3> lit(const std::array<float, 3>& share, const LightGain& light) {
  const std::array<float, 3> c{share[0] * light.rgb[0], share[1] * light.rgb[1],
                               share[2] * light.rgb[2]};
  const float sum = c[0] + c[1] + c[2];
  if (!(sum > 0)) return share;
  return {c[0] / sum, c[1] / sum, c[2] / sum};
}

void SeenColours::look(const RegionMap& regions, const Planes& colours, int blob,
                       const ObjectModel& model, const LightGain& light) {
  regions_ = &regions;
  knows_all_ = blob == kAllBlobs;
  hidden_ = nullptr;
  colours_ = &colours;
  class_of_label_[0] = kBackgroundClass;
  expect(model, light);
  for (std::size_t r = 0; r < regions.regions.size(); ++r) {
    const Region& region = regions.regions[r];
    class_of_label_[r + 1] =
        blob == kAllBlobs || region.blob == blob ? nearest_to(region.mean_rgb) : kBackgroundClass;
  }
}

void SeenColours::look_at_pixels(const Planes& colours, const Box& known, const HiddenPart* hidden,
                                 const ObjectModel& model, const LightGain& light) {
  regions_ = nullptr;
  hidden_ = hidden;
  known_ = known;
  colours_ = &colours;
  class_of_label_[0] = kBackgroundClass;
  expect(model, light);
}

void SeenColours::expect(const ObjectModel& model, const LightGain& light) {
  colour_count_ = std::min(model.shares.size(), kMaxModelColours);
  for (std::size_t k = 0; k < colour_count_; ++k) {
    const std::array<float, 3> share = lit(model.shares[k], light);
    for (std::size_t c = 0; c < 3; ++c) expected_[c][k] = share[c];
  }
}

ColourClass SeenColours::nearest_to(const std::array<float, 3>& rgb) const {
  const float sum = std::max(1.0F, rgb[0] + rgb[1] + rgb[2]);
  const std::array<float, 3> share{rgb[0] / sum, rgb[1] / sum, rgb[2] / sum};
  // As nearest_share, all distances at once: vector code.
  std::array<float, kMaxModelColours> distance;
  for (std::size_t k = 0; k < colour_count_; ++k) {
    const float red = expected_[0][k] - share[0], green = expected_[1][k] - share[1],
                blue = expected_[2][k] - share[2];
    distance[k] = red * red + green * green + blue * blue;
  }
  ColourClass nearest = kOther;
  float least = kFarthestShare * kFarthestShare;
  for (std::size_t k = 0; k < colour_count_; ++k) {
    if (distance[k] >= least) continue;
    least = distance[k];
    nearest = static_cast<ColourClass>(k + 1);
  }
  return nearest;
}

ColourClass SeenColours::at_pixel(float x_px, float y_px) const {
  return named(rgb(x_px, y_px));
}

ColourClass SeenColours::named(const std::array<float, 3>& colour) const {
  constexpr float kLeastSum = 40;
  return colour[0] + colour[1] + colour[2] < kLeastSum ? kBackgroundClass : nearest_to(colour);
}

std::uint16_t SeenColours::label_at(float x_px, float y_px) const {
  if (regions_ == nullptr) return 0;
  const int x = static_cast<int>(std::floor(x_px + 0.5F)),
            y = static_cast<int>(std::floor(y_px + 0.5F));
  if (!holds(regions_->active, x, y)) return 0;
  return regions_->labels[static_cast<std::size_t>(y * regions_->stride_px + x)];
}

ColourClass SeenColours::at(float x_px, float y_px) const {
  if (regions_ == nullptr) {
    if (is_hidden(x_px, y_px)) return kUnknown;
    const int x = static_cast<int>(std::floor(x_px + 0.5F)),
              y = static_cast<int>(std::floor(y_px + 0.5F));
    if (!holds(colours_->active, x, y)) return holds(known_, x, y) ? kBackgroundClass : kUnknown;
    const std::size_t place = colours_->place(x, y);
    return named({static_cast<float>(colours_->red[place]),
                  static_cast<float>(colours_->green[place]),
                  static_cast<float>(colours_->blue[place])});
  }
  const std::uint16_t label = label_at(x_px, y_px);
  if (label == 0 && !knows_all_ &&
      !holds(regions_->looked_at, static_cast<int>(std::floor(x_px + 0.5F)),
             static_cast<int>(std::floor(y_px + 0.5F))))
    return kUnknown;
  return class_of_label_[label];
}

std::array<float, 3> SeenColours::rgb(float x_px, float y_px) const {
  const float fx = std::floor(x_px), fy = std::floor(y_px);
  const float u = x_px - fx, v = y_px - fy;
  const int x = static_cast<int>(fx), y = static_cast<int>(fy);
  std::array<float, 3> sum{};
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      if (!holds(colours_->active, x + i, y + j)) continue;
      const float weight = (i == 0 ? 1 - u : u) * (j == 0 ? 1 - v : v);
      const std::size_t place = colours_->place(x + i, y + j);
      sum[0] += weight * static_cast<float>(colours_->red[place]);
      sum[1] += weight * static_cast<float>(colours_->green[place]);
      sum[2] += weight * static_cast<float>(colours_->blue[place]);
    }
  return sum;
}

}  // namespace aspect
