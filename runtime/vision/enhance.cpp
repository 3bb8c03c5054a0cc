// Step 1 is a 3 x 3 median as a network of minima and maxima: each column of three is sorted once
// and shared by the three windows that it stands in; the median of nine is then the median of the
// largest low, the middle middle and the smallest high (Smith, "Implementing median filters in
// XC4000E FPGAs", 1996). It keeps straight edges exactly, rounds corners by a pixel and removes
// lines one pixel wide. Step 2 divides by the intensity through a table of reciprocals.
#include "runtime/vision/enhance.h"

#include <algorithm>

namespace aspect {
namespace {

using Byte = std::uint8_t;

inline Byte median3(Byte a, Byte b, Byte c) {
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

// Sorts each column of three. Outputs that alias nothing let compilers make vector code of this.
void sort_columns(const Byte* above, const Byte* row, const Byte* below, int width,
                  Byte* __restrict low, Byte* __restrict middle, Byte* __restrict high) {
  for (int x = 0; x < width; ++x) {
    const Byte least = std::min(above[x], row[x]), most = std::max(above[x], row[x]);
    const Byte rest = std::max(least, below[x]);
    low[x] = std::min(least, below[x]);
    middle[x] = std::min(rest, most);
    high[x] = std::max(rest, most);
  }
}

void median_row(const Byte* low, const Byte* middle, const Byte* high, int width,
                Byte* __restrict out) {
  for (int x = 1; x + 1 < width; ++x) {
    const Byte lows = std::max(std::max(low[x - 1], low[x]), low[x + 1]);
    const Byte highs = std::min(std::min(high[x - 1], high[x]), high[x + 1]);
    out[x] = median3(lows, median3(middle[x - 1], middle[x], middle[x + 1]), highs);
  }
}

void smooth_plane(std::span<const Byte> from, int stride, const Box& box, std::span<Byte> scratch,
                  std::span<Byte> to) {
  const auto width = static_cast<std::size_t>(box.width);
  for (int y = 0; y < box.height; ++y) {
    const Byte* row = from.data() + (box.y + y) * stride + box.x;
    Byte* out = to.data() + (box.y + y) * stride + box.x;
    if (y == 0 || y + 1 == box.height)
      std::copy_n(row, width, out);
    else
      smooth_row(row - stride, row, row + stride, box.width, scratch, out);
  }
}

constexpr int kLargestSum = 3 * 255;

// share = floor(colour * floor(255 * 2^16 / sum) / 2^16). Floats hold all of this so exactly that
// cutting off gives what integers would, and vectors of them divide faster than a table answers.
void share_row(const Byte* red, const Byte* green, const Byte* blue, int width,
               const VisionParameters& parameters, Byte* __restrict red_share,
               Byte* __restrict green_share, Byte* __restrict blue_share,
               Byte* __restrict tolerance) {
  constexpr float kOne = 65536.0F;
  const int chroma_step = std::clamp(parameters.chroma_step, 0, 255);
  const auto noise = static_cast<float>(255 * std::clamp(parameters.noise_steps, 0, kLargestSum));
  for (int x = 0; x < width; ++x) {
    const int total = red[x] + green[x] + blue[x];
    const auto sum = static_cast<float>(total + (total == 0 ? 1 : 0));
    const float factor = static_cast<float>(static_cast<int>(255 * kOne / sum)) / kOne;
    red_share[x] = static_cast<Byte>(static_cast<int>(static_cast<float>(red[x]) * factor));
    green_share[x] = static_cast<Byte>(static_cast<int>(static_cast<float>(green[x]) * factor));
    blue_share[x] = static_cast<Byte>(static_cast<int>(static_cast<float>(blue[x]) * factor));
    const int step = chroma_step + static_cast<int>(noise / sum);
    tolerance[x] = static_cast<Byte>(step > 255 ? 255 : step);
  }
}

void intensity_row(const Byte* red, const Byte* green, const Byte* blue, int width,
                   Byte* __restrict intensity) {
  for (int x = 0; x < width; ++x) {
    const Byte most = std::max(std::max(red[x], green[x]), blue[x]);
    const auto five = static_cast<std::uint16_t>(red[x] + green[x] + blue[x] + 2 * most);
    intensity[x] = static_cast<Byte>((five * 13108U) >> 16U);
  }
}

void foreground_row(const Byte* red, const Byte* green, const Byte* blue, int width,
                    std::uint16_t least, Byte* __restrict foreground) {
  for (int x = 0; x < width; ++x) {
    const auto sum = static_cast<std::uint16_t>(red[x] + green[x] + blue[x]);
    foreground[x] = sum >= least ? Byte{255} : Byte{0};
  }
}

}  // namespace

void smooth_row(const Byte* above, const Byte* row, const Byte* below, int width,
                std::span<Byte> scratch, Byte* out) {
  Byte* low = scratch.data();
  Byte* middle = low + width;
  Byte* high = middle + width;
  sort_columns(above, row, below, width, low, middle, high);
  median_row(low, middle, high, width, out);
  out[0] = row[0];
  out[width - 1] = row[width - 1];
}

void smooth(const Planes& from, std::span<Byte> scratch, Planes& to) {
  to.active = from.active;
  smooth_plane(from.red, from.stride_px, from.active, scratch, to.red);
  if (from.is_grey()) return;
  smooth_plane(from.green, from.stride_px, from.active, scratch, to.green);
  smooth_plane(from.blue, from.stride_px, from.active, scratch, to.blue);
}

void normalise(const Byte* red, const Byte* green, const Byte* blue, int count,
               const VisionParameters& parameters, const MutableShareRow& out) {
  share_row(red, green, blue, count, parameters, out.red, out.green, out.blue, out.tolerance);
  intensity_row(red, green, blue, count, out.intensity);
  find_foreground(red, green, blue, count, parameters.intensity_min, out.foreground);
}

void find_foreground(const Byte* red, const Byte* green, const Byte* blue, int count,
                     int intensity_min, Byte* foreground) {
  const auto least = static_cast<std::uint16_t>(std::clamp(intensity_min, 1, kLargestSum + 1));
  foreground_row(red, green, blue, count, least, foreground);
}

}  // namespace aspect
