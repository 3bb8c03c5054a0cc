#include "runtime/vision/share_rows.h"

#include <algorithm>

namespace aspect {
namespace {

constexpr std::size_t kKinds = 6;
constexpr int kLargestSum = 3 * 255;

// 255 / sum in 1/65536, what normalise() multiplies by.
constexpr auto kReciprocals = [] {
  std::array<std::uint32_t, kLargestSum + 1> table{};
  for (std::uint32_t sum = 0; sum < table.size(); ++sum)
    table[sum] = (255U << 16U) / (sum == 0 ? 1 : sum);
  return table;
}();

}  // namespace

void ShareRows::take(Arena& arena, int width_px) {
  width_ = static_cast<std::size_t>(width_px);
  rows_ = arena.take<std::uint8_t>(kRows * kKinds * width_);
  foreground_ = arena.take<std::uint8_t>(width_);
}

MutableShareRow ShareRows::stored(int slot) const {
  std::uint8_t* first = rows_.data() + static_cast<std::size_t>(slot) * kKinds * width_;
  return {first,
          first + width_,
          first + 2 * width_,
          first + 3 * width_,
          first + 4 * width_,
          first + 5 * width_};
}

void ShareRows::begin(const EnhancedFrame& frame, const VisionParameters& parameters) {
  frame_ = frame;
  parameters_ = parameters;
  row_of_slot_.fill(-1);
  if (frame.codes == nullptr) return tabulate_tolerances();
  // Codes have no intensity, and one tolerance.
  const MutableShareRow alike = stored(0);
  std::fill_n(alike.intensity, width_, std::uint8_t{0});
  std::fill_n(alike.tolerance, width_, frame.code_tolerance);
}

// As normalise() has it.
void ShareRows::tabulate_tolerances() {
  const int chroma_step = std::clamp(parameters_.chroma_step, 0, 255);
  const int noise = 255 * std::clamp(parameters_.noise_steps, 0, kLargestSum);
  for (int sum = 0; sum < kSums; ++sum)
    tolerance_of_sum_[static_cast<std::size_t>(sum)] =
        static_cast<std::uint8_t>(std::min(chroma_step + noise / std::max(sum, 1), 255));
}

ShareRow ShareRows::compute(int y, int slot) {
  const Planes& planes = frame_.planes;
  const std::size_t at = planes.place(planes.active.x, y);
  const std::uint8_t* red = planes.red.data() + at;
  const std::uint8_t* green = planes.green.data() + at;
  const std::uint8_t* blue = planes.blue.data() + at;
  if (frame_.codes != nullptr) {
    const MutableShareRow alike = stored(0);
    return {
        red, green, blue, alike.intensity, alike.tolerance, frame_.codes->foreground.data() + at};
  }
  const MutableShareRow out = stored(slot);
  normalise(red, green, blue, planes.active.width, parameters_, out);
  return {out.red, out.green, out.blue, out.intensity, out.tolerance, out.foreground};
}

ShareRow ShareRows::row(int y) {
  const int slot = y % kRows;
  int& stored_row = row_of_slot_[static_cast<std::size_t>(slot)];
  if (stored_row == y && frame_.codes == nullptr) {
    const MutableShareRow out = stored(slot);
    return {out.red, out.green, out.blue, out.intensity, out.tolerance, out.foreground};
  }
  stored_row = y;
  return compute(y, slot);
}

PixelShares ShareRows::pixel(std::size_t place) const {
  const Planes& planes = frame_.planes;
  const std::uint8_t red = planes.red[place], green = planes.green[place];
  const std::uint8_t blue = planes.blue[place];
  if (frame_.codes != nullptr) return {{red, green, blue}, 0, frame_.code_tolerance};
  const unsigned sum = unsigned{red} + green + blue;
  const std::uint32_t factor = kReciprocals[sum];
  const auto share = [&](unsigned value) {
    return static_cast<std::uint8_t>(value * factor >> 16U);
  };
  return {{share(red), share(green), share(blue)},
          static_cast<std::uint8_t>((sum + 2U * std::max({red, green, blue})) / 5),
          tolerance_of_sum_[sum]};
}

const std::uint8_t* ShareRows::foreground(int y) {
  const Planes& planes = frame_.planes;
  const std::size_t at = planes.place(planes.active.x, y);
  if (frame_.codes != nullptr) return frame_.codes->foreground.data() + at;
  find_foreground(planes.red.data() + at, planes.green.data() + at, planes.blue.data() + at,
                  planes.active.width, parameters_.intensity_min, foreground_.data());
  return foreground_.data();
}

}  // namespace aspect
