#include "compiler/render/pixel_writer.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace aspect {
namespace {

// Sixteen pixels of one colour, copied as a whole.
class ColorRun {
 public:
  explicit ColorRun(const Rgb& color) : grey_(color[0] == color[1] && color[1] == color[2]) {
    for (std::size_t k = 0; k < pattern_.size(); ++k) pattern_[k] = color[k % 3];
  }

  void write(std::uint8_t* bytes, std::size_t count) const {
    if (grey_) {
      std::memset(bytes, pattern_[0], count);
      return;
    }
    for (; count >= pattern_.size(); count -= pattern_.size(), bytes += pattern_.size())
      std::memcpy(bytes, pattern_.data(), pattern_.size());
    std::memcpy(bytes, pattern_.data(), count);
  }

 private:
  std::array<std::uint8_t, 48> pattern_{};
  bool grey_;
};

}  // namespace

void PixelWriter::fill_background(const Box& box, const Rgb& color) {
  const ColorRun run(color);
  const auto width = static_cast<std::size_t>(box.width);
  for (int y = box.y; y < box.y + box.height; ++y) {
    const std::size_t first = pixel(box.x, y);
    run.write(&picture_.rgb[3 * first], 3 * width);
    std::fill_n(&picture_.surface[first], width, std::uint16_t{0});
    std::fill_n(&picture_.depth[first], width, std::numeric_limits<float>::infinity());
  }
}

void PixelWriter::fill_plane(const Box& box, std::uint16_t surface, const Rgb& color,
                             const InverseDepth& plane) {
  const ColorRun run(color);
  const auto width = static_cast<std::size_t>(box.width);
  const auto step = static_cast<float>(plane.x);
  for (int y = box.y; y < box.y + box.height; ++y) {
    const std::size_t first = pixel(box.x, y);
    run.write(&picture_.rgb[3 * first], 3 * width);
    std::fill_n(&picture_.surface[first], width, surface);
    const auto start = static_cast<float>(plane.at(box.x, y));
    float* depth = &picture_.depth[first];
    for (int k = 0; k < box.width; ++k) depth[k] = 1 / (start + step * static_cast<float>(k));
  }
}

}  // namespace aspect
