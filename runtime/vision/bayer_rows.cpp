// In every row green takes turns with one other colour; seen from the pixels of that other colour,
// the third stands at the four corners, and seen from the green ones, above and below. Both answers
// are computed for all pixels and a mask picks one, which compilers turn into vector code.
#include "runtime/vision/bayer_rows.h"

#include <algorithm>
#include <utility>

namespace aspect {
namespace {

using Byte = std::uint8_t;

constexpr int kPixels = 64;  // of a block; even, so that every block starts on the same colour
constexpr int kRow = kPixels + 2;

// Three rows with a pixel more at either side.
struct Block {
  Byte above[kRow], here[kRow], below[kRow];
};

int mirrored(int at, int size) {
  if (at < 0) return std::min(-at, size - 1);
  return at < size ? at : std::max(2 * size - 2 - at, 0);
}

void load_row(const Byte* row, int width, int x, Byte* out) {
  const int begin = x - 1, inside = std::max(begin, 0), end = std::min(begin + kRow, width);
  for (int at = begin; at < inside; ++at) out[at - begin] = row[mirrored(at, width)];
  std::copy(row + inside, row + end, out + (inside - begin));
  for (int at = end; at < begin + kRow; ++at) out[at - begin] = row[mirrored(at, width)];
}

inline Byte pick(Byte mask, int a, int b) {
  return static_cast<Byte>((a & mask) | (b & ~mask));
}

// `own` is the colour that takes turns with green in this row, `third` the one that it lacks;
// green_mask is 255 where a pixel is behind green.
void interpolate(const Block& block, const Byte* green_mask, Byte* __restrict own,
                 Byte* __restrict green, Byte* __restrict third) {
  for (int i = 0; i < kPixels; ++i) {
    const int here = block.here[i + 1];
    const int sides = block.here[i] + block.here[i + 2];
    const int ends = block.above[i + 1] + block.below[i + 1];
    const int corners = block.above[i] + block.above[i + 2] + block.below[i] + block.below[i + 2];
    own[i] = pick(green_mask[i], (sides + 1) >> 1, here);
    green[i] = pick(green_mask[i], here, (sides + ends + 2) >> 2);
    third[i] = pick(green_mask[i], (ends + 1) >> 1, (corners + 2) >> 2);
  }
}

struct Filter {
  bool red_row;       // red and green take turns in this row
  int first_green_x;  // 0 or 1
};

Filter filter_of(PixelFormat format, int y) {
  const bool red_first = format == PixelFormat::bayer_rggb8 || format == PixelFormat::bayer_grbg8;
  const bool green_first = format == PixelFormat::bayer_grbg8 || format == PixelFormat::bayer_gbrg8;
  const bool odd = y % 2 != 0;
  return {red_first != odd, green_first != odd ? 0 : 1};
}

}  // namespace

void bayer_row(const Frame& frame, int y, int x, int count, Byte* red, Byte* green, Byte* blue) {
  const auto row = [&](int at) {
    return frame.data + mirrored(at, frame.height_px) * frame.stride_bytes;
  };
  const Filter filter = filter_of(frame.format, y);
  Byte mask[kPixels], part[3][kPixels];
  for (int i = 0; i < kPixels; ++i) mask[i] = (x + i) % 2 == filter.first_green_x ? 255 : 0;
  if (!filter.red_row) std::swap(red, blue);
  Block block;
  for (int first = 0; first < count; first += kPixels) {
    load_row(row(y - 1), frame.width_px, x + first, block.above);
    load_row(row(y), frame.width_px, x + first, block.here);
    load_row(row(y + 1), frame.width_px, x + first, block.below);
    interpolate(block, mask, part[0], part[1], part[2]);
    const int length = std::min(count - first, kPixels);
    std::copy_n(part[0], length, red + first);
    std::copy_n(part[1], length, green + first);
    std::copy_n(part[2], length, blue + first);
  }
}

}  // namespace aspect
