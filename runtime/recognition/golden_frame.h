// A small picture of the object that its index carries, and the answer to it: what a device looks
// at when it is switched on. Cut into regions of one colour each, and cropped to the object.
//
// Its rows are a string of bits, highest first, in Exp-Golomb codes (n + 1 in binary, after as many
// zeros as it has digits behind the first). A row is a list of runs, each a colour and where it
// ends; what lies behind the last is background, colour 0. It begins with a bit:
//   1  the runs of the row above; each end moves as it did there, changed by a number (0, 1, -1, 2,
//      -2... as 0, 1, 2, 3, 4...): straight borders cost little more than a bit
//   0  a number of runs, then the colour and the length of each
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/vision/frame.h"
#include "runtime/vision/sensor_kind.h"

namespace aspect {

inline constexpr int kMaxGoldenPixels = 512 * 512, kMaxGoldenSide_px = 4096;
inline constexpr std::size_t kMaxGoldenColours = 256;  // the background among them
inline constexpr std::size_t kMaxGoldenRuns = 256;     // of a row

struct GoldenFrame {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t>
      palette;  // bytes of the colours' pixels, little-endian, from colour 1 on
  std::vector<std::uint8_t> rows;

  // The one object in it, as its index alone answers.
  std::uint16_t class_id = 0;
  int regions = 0, matched = 0;
  float score = 0;
};

// Of the frames of a sensor that has golden frames: a range picture's depths are not a few colours.
constexpr bool has_golden_frames(SensorKind sensor) {
  return sensor != SensorKind::range;
}
constexpr PixelFormat golden_format(SensorKind sensor) {
  if (sensor == SensorKind::grey) return PixelFormat::grey8;
  return sensor == SensorKind::surface ? PixelFormat::label16 : PixelFormat::rgb8;
}

// Of a picture of a size that can be.
std::size_t golden_picture_bytes(const GoldenFrame& golden, SensorKind sensor);

// Size, palette and every row are checked; nothing is written. O(rows).
bool is_sound(const GoldenFrame& golden, SensorKind sensor) noexcept;

// Writes a sound golden frame's picture into `pixels`, of golden_picture_bytes, and returns it.
Frame decode_golden_frame(const GoldenFrame& golden, SensorKind sensor,
                          std::span<std::uint8_t> pixels) noexcept;

}  // namespace aspect
