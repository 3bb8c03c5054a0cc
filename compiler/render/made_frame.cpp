#include "compiler/render/made_frame.h"

#include <algorithm>
#include <array>

namespace aspect {
namespace {

// About normal, of deviation 1.
std::vector<float> noise_samples() {
  constexpr std::size_t kCount = 1U << 14U;
  Dice dice(0);
  std::vector<float> samples(kCount);
  for (float& sample : samples) {
    double sum = -6;
    for (int k = 0; k < 12; ++k) sum += dice.between(0, 1);
    sample = static_cast<float>(sum);
  }
  return samples;
}

// Binomial, three pixels wide, along rows or columns.
void blur(MadeFrame& frame, int right, int down) {
  const MadeFrame source = frame;
  const std::ptrdiff_t step = 3 * (std::ptrdiff_t{down} * frame.width_px + right);
  for (int y = down; y + down < frame.height_px; ++y) {
    const float* from = &source.rgb[3 * static_cast<std::size_t>(y * frame.width_px + right)];
    float* to = frame.at(right, y);
    const std::ptrdiff_t count = std::ptrdiff_t{3} * (frame.width_px - 2 * right);
    for (std::ptrdiff_t k = 0; k < count; ++k)
      to[k] = (from[k - step] + 2 * from[k] + from[k + step]) / 4;
  }
}

}  // namespace

std::vector<std::uint8_t> photographed(MadeFrame frame, Dice& dice) {
  static const std::vector<float> noise_of = noise_samples();
  const auto noise = static_cast<float>(dice.between(0.5, 3));
  const double light = dice.between(0.6, 1.05);
  std::array<float, 3> gain;
  for (float& g : gain) g = static_cast<float>(light * dice.between(0.85, 1.15));
  const int blurs = static_cast<int>(dice.below(3));
  for (int k = 0; k < blurs; ++k) {
    blur(frame, 1, 0);
    blur(frame, 0, 1);
  }
  std::vector<std::uint8_t> bytes(frame.rgb.size());
  constexpr std::size_t kRun = 256;  // samples that follow one another
  // Of each channel in turn, as long as a run from any channel on.
  std::array<float, kRun + 2> gains;
  for (std::size_t k = 0; k < gains.size(); ++k) gains[k] = gain[k % 3];
  for (std::size_t begin = 0; begin < bytes.size(); begin += kRun) {
    const std::size_t count = std::min(kRun, bytes.size() - begin);
    const float* samples = &noise_of[dice.below(noise_of.size() - kRun)];
    const float* gain_of = &gains[begin % 3];
    const float* from = &frame.rgb[begin];
    for (std::size_t k = 0; k < count; ++k)
      bytes[begin + k] = static_cast<std::uint8_t>(
          std::clamp(from[k] * gain_of[k] + noise * samples[k] + 0.5F, 0.0F, 255.0F));
  }
  return bytes;
}

}  // namespace aspect
