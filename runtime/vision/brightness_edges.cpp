#include "runtime/vision/brightness_edges.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace aspect {
namespace {

// Brightness is 0..255, so is half a bend at most.
using Histogram = std::array<int, 512>;

// Bends over five pixels: those that smoothing has made alike do not hide the noise.
constexpr int kReach_px = 2, kRowStep = 16;

int brightness(const Planes& planes, std::size_t i) {
  const int red = planes.red[i], green = planes.green[i], blue = planes.blue[i];
  return (red + green + blue + 2 * std::max({red, green, blue})) / 5;
}

void add_row(const Planes& planes, int y, int intensity_min, Histogram& bends) {
  const std::size_t first = planes.place(planes.active.x, y);
  const auto width = static_cast<std::size_t>(planes.active.width);
  for (std::size_t i = first + kReach_px; i + kReach_px < first + width; ++i) {
    if (planes.red[i] + planes.green[i] + planes.blue[i] < intensity_min) continue;
    const int bend = brightness(planes, i - kReach_px) - 2 * brightness(planes, i) +
                     brightness(planes, i + kReach_px);
    ++bends[static_cast<std::size_t>(std::min(std::abs(bend), 511))];
  }
}

double mean_of_lower_half(const Histogram& bends) {
  int all = 0;
  for (const int count : bends) all += count;
  int left = all / 2;
  double sum = 0;
  for (std::size_t bend = 0; left > 0; ++bend) {
    const int taken = std::min(left, bends[bend]);
    sum += static_cast<double>(bend) * taken;
    left -= taken;
  }
  return all < 2 ? 0 : sum / (all / 2);
}

}  // namespace

int measured_intensity_step(const Planes& planes, int intensity_min) {
  // Of a camera's usual noise, 24; without any, the finest that shading within a face allows.
  constexpr double kFinest = 15, kOfNoise = 13;
  constexpr int kCoarsest = 90;
  Histogram bends{};
  const Box& box = planes.active;
  for (int y = box.y + kRowStep / 2; y < box.y + box.height; y += kRowStep)
    add_row(planes, y, intensity_min, bends);
  return std::min(kCoarsest, static_cast<int>(kFinest + kOfNoise * mean_of_lower_half(bends)));
}

}  // namespace aspect
