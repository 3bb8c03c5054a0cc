#include "runtime/recognition/golden_frame.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "runtime/base/check.h"

namespace aspect {
namespace {

class BitReader {
 public:
  explicit BitReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  // Zeros for ever behind the end, where a number has too many of them.
  unsigned bit() {
    if (place_ >= 8 * bytes_.size()) return 0;
    const unsigned byte = bytes_[place_ / 8];
    return byte >> (7 - place_++ % 8) & 1U;
  }

  // A number below 2^16 - 1; -1 where there is none.
  int number() {
    int zeros = 0;
    while (bit() == 0)
      if (++zeros == 16) return -1;
    unsigned value = 1;
    for (int k = 0; k < zeros; ++k) value = value << 1U | bit();
    return static_cast<int>(value) - 1;
  }

  // Less than a byte is left.
  bool at_end() const { return place_ + 8 > 8 * bytes_.size(); }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t place_ = 0;
};

// The runs of one row after the other.
class RowReader {
 public:
  RowReader(const GoldenFrame& golden, std::size_t colours)
      : bits_(golden.rows), width_(golden.width_px), colours_(colours) {}

  struct Run {
    int end = 0;
    int move = 0;  // of the end, against the row above
    std::size_t colour = 0;
  };

  // False where the bits hold no such row.
  bool next() { return bits_.bit() != 0 ? move_ends() : read_anew(); }
  std::span<const Run> runs() const { return std::span(runs_).first(count_); }
  bool at_end() const { return bits_.at_end(); }

 private:
  bool move_ends() {
    int begin = 0;
    for (Run& run : std::span(runs_).first(count_)) {
      const int code = bits_.number();
      if (code < 0) return false;
      run.move += code % 2 != 0 ? (code + 1) / 2 : -(code / 2);
      run.end += run.move;
      if (run.end <= begin || run.end > width_) return false;
      begin = run.end;
    }
    return true;
  }

  bool read_anew() {
    const int count = bits_.number();
    if (count < 0 || static_cast<std::size_t>(count) > runs_.size()) return false;
    count_ = static_cast<std::size_t>(count);
    int begin = 0;
    for (Run& run : std::span(runs_).first(count_)) {
      const int colour = bits_.number(), length = bits_.number();
      if (colour < 0 || static_cast<std::size_t>(colour) >= colours_) return false;
      if (length < 1 || length > width_ - begin) return false;
      begin += length;
      run = {begin, 0, static_cast<std::size_t>(colour)};
    }
    return true;
  }

  BitReader bits_;
  int width_;
  std::size_t colours_;
  std::array<Run, kMaxGoldenRuns> runs_{};
  std::size_t count_ = 0;
};

std::size_t pixel_bytes(SensorKind sensor) {
  return static_cast<std::size_t>(bytes_per_pixel(golden_format(sensor)));
}

bool size_can_be(const GoldenFrame& golden) {
  return golden.width_px > 0 && golden.height_px > 0 && golden.width_px <= kMaxGoldenSide_px &&
         golden.height_px <= kMaxGoldenSide_px &&
         golden.width_px * golden.height_px <= kMaxGoldenPixels;
}

}  // namespace

std::size_t golden_picture_bytes(const GoldenFrame& golden, SensorKind sensor) {
  ASPECT_CHECK(size_can_be(golden));
  return static_cast<std::size_t>(golden.width_px * golden.height_px) * pixel_bytes(sensor);
}

bool is_sound(const GoldenFrame& golden, SensorKind sensor) noexcept {
  const std::size_t pixel = pixel_bytes(sensor), colours = golden.palette.size() / pixel + 1;
  if (!has_golden_frames(sensor) || !size_can_be(golden) || golden.palette.size() % pixel != 0 ||
      colours > kMaxGoldenColours)
    return false;
  RowReader reader(golden, colours);
  for (int y = 0; y < golden.height_px; ++y)
    if (!reader.next()) return false;
  return reader.at_end();
}

Frame decode_golden_frame(const GoldenFrame& golden, SensorKind sensor,
                          std::span<std::uint8_t> pixels) noexcept {
  ASPECT_CHECK(pixels.size() >= golden_picture_bytes(golden, sensor));
  const std::size_t pixel = pixel_bytes(sensor);
  const std::size_t row_bytes = static_cast<std::size_t>(golden.width_px) * pixel;
  std::fill(pixels.begin(), pixels.end(), std::uint8_t{0});
  RowReader reader(golden, golden.palette.size() / pixel + 1);
  for (std::size_t y = 0; y < static_cast<std::size_t>(golden.height_px) && reader.next(); ++y) {
    std::uint8_t* row = pixels.data() + y * row_bytes;
    std::size_t x = 0;
    for (const RowReader::Run& run : reader.runs()) {
      const auto end = static_cast<std::size_t>(run.end);
      for (; run.colour > 0 && x < end; ++x) {
        const std::uint8_t* colour = golden.palette.data() + (run.colour - 1) * pixel;
        std::memcpy(row + x * pixel, colour, pixel);
        if (std::endian::native == std::endian::big && pixel == 2)
          std::swap(row[x * pixel], row[x * pixel + 1]);
      }
      x = end;
    }
  }
  return {pixels.data(), golden.width_px, golden.height_px, static_cast<std::ptrdiff_t>(row_bytes),
          golden_format(sensor)};
}

}  // namespace aspect
