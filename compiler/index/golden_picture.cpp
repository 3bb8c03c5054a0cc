#include "compiler/index/golden_picture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>

namespace aspect {
namespace {

class BitWriter {
 public:
  explicit BitWriter(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

  void bit(unsigned value) {
    if (place_ % 8 == 0) bytes_.push_back(0);
    bytes_.back() = static_cast<std::uint8_t>(bytes_.back() | value << (7 - place_++ % 8));
  }
  void number(int value) {
    const auto next = static_cast<unsigned>(value) + 1;
    const auto digits = static_cast<unsigned>(std::bit_width(next));
    for (unsigned k = 1; k < digits; ++k) bit(0);
    for (unsigned k = digits; k-- > 0;) bit(next >> k & 1U);
  }
  void signed_number(int value) { number(value > 0 ? 2 * value - 1 : -2 * value); }

 private:
  std::vector<std::uint8_t>& bytes_;
  std::size_t place_ = 0;
};

struct GoldenRun {
  int end = 0, move = 0;
  std::uint8_t colour = 0;
};
using GoldenRow = std::vector<GoldenRun>;

GoldenRow runs_of(const std::uint8_t* row, int width) {
  GoldenRow runs;
  for (int x = 0; x < width; ++x)
    if (runs.empty() || runs.back().colour != row[x])
      runs.push_back({x + 1, 0, row[x]});
    else
      runs.back().end = x + 1;
  if (!runs.empty() && runs.back().colour == 0) runs.pop_back();
  return runs;
}

bool same_colours(const GoldenRow& a, const GoldenRow& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const GoldenRun& x, const GoldenRun& y) { return x.colour == y.colour; });
}

void write_moved(const GoldenRow& above, GoldenRow& row, BitWriter& bits) {
  bits.bit(1);
  for (std::size_t k = 0; k < row.size(); ++k) {
    row[k].move = row[k].end - above[k].end;
    bits.signed_number(row[k].move - above[k].move);
  }
}

void write_anew(const GoldenRow& row, BitWriter& bits) {
  bits.bit(0);
  bits.number(static_cast<int>(row.size()));
  int begin = 0;
  for (const GoldenRun& run : row) {
    bits.number(run.colour);
    bits.number(run.end - begin);
    begin = run.end;
  }
}

// The number of the surface that most pixels of each label show.
std::vector<std::uint16_t> main_surfaces(const Frame& frame, const RegionMap& map) {
  std::vector<std::map<std::uint16_t, int>> counts(map.regions.size() + 1);
  for (const Run& run : map.runs) {
    const std::uint8_t* row = frame.data + run.row * frame.stride_bytes;
    for (int x = run.begin; x < run.end; ++x) {
      std::uint16_t surface = 0;
      std::memcpy(&surface, row + 2 * x, sizeof surface);
      ++counts[run.label][surface];
    }
  }
  const auto fewer = [](const auto& a, const auto& b) { return a.second < b.second; };
  std::vector<std::uint16_t> surfaces;
  for (const auto& count : counts)
    surfaces.push_back(count.empty() ? std::uint16_t{0}
                                     : std::max_element(count.begin(), count.end(), fewer)->first);
  return surfaces;
}

// By label: the bytes of a pixel, the first one lowest.
std::vector<std::uint32_t> region_colours(const Frame& frame, const RegionMap& map,
                                          SensorKind sensor) {
  if (sensor == SensorKind::surface) {
    const std::vector<std::uint16_t> surfaces = main_surfaces(frame, map);
    return {surfaces.begin(), surfaces.end()};
  }
  const std::size_t channels = sensor == SensorKind::grey ? 1 : 3;
  std::vector<std::uint32_t> colours(1, 0);
  for (const Region& region : map.regions) {
    colours.push_back(0);
    for (std::size_t k = 0; k < channels; ++k)
      colours.back() |=
          static_cast<std::uint32_t>(std::lround(std::clamp(region.mean_rgb[k], 0.0F, 255.0F)))
          << 8 * k;
  }
  return colours;
}

// Of all regions, with the margin, within the frame.
Box crop_of(const RegionMap& map, const Frame& frame) {
  int left = frame.width_px, right = 0, top = frame.height_px, bottom = 0;
  for (const Run& run : map.runs) {
    if (run.label == 0) continue;
    left = std::min<int>(left, run.begin - kGoldenMargin_px);
    right = std::max<int>(right, run.end + kGoldenMargin_px);
    top = std::min<int>(top, run.row - kGoldenMargin_px);
    bottom = std::max<int>(bottom, run.row + 1 + kGoldenMargin_px);
  }
  left = std::max(left, 0);
  top = std::max(top, 0);
  return {left, top, std::min(right, frame.width_px) - left,
          std::min(bottom, frame.height_px) - top};
}

// Gives equal colours one number and lists each once. By label; 0, the background, stays 0.
std::vector<std::size_t> number_colours(const std::vector<std::uint32_t>& colours,
                                        std::size_t pixel_bytes,
                                        std::vector<std::uint8_t>& palette) {
  std::map<std::uint32_t, std::size_t> numbers;
  std::vector<std::size_t> number_of_label(1, 0);
  for (std::size_t label = 1; label < colours.size(); ++label) {
    const auto [found, is_new] = numbers.emplace(colours[label], numbers.size() + 1);
    for (std::size_t k = 0; is_new && k < pixel_bytes; ++k)
      palette.push_back(static_cast<std::uint8_t>(colours[label] >> 8 * k & 255U));
    number_of_label.push_back(found->second);
  }
  return number_of_label;
}

}  // namespace

std::optional<PalettePicture> palette_picture(const Frame& frame, const RegionMap& map,
                                              SensorKind sensor) {
  if (!has_golden_frames(sensor) || map.regions.empty()) return std::nullopt;
  PalettePicture picture;
  const std::vector<std::size_t> number_of_label = number_colours(
      region_colours(frame, map, sensor),
      static_cast<std::size_t>(bytes_per_pixel(golden_format(sensor))), picture.palette);
  const Box crop = crop_of(map, frame);
  if (*std::max_element(number_of_label.begin(), number_of_label.end()) >= kMaxGoldenColours ||
      crop.width > kMaxGoldenSide_px || crop.height > kMaxGoldenSide_px ||
      crop.width * crop.height > kMaxGoldenPixels)
    return std::nullopt;
  picture.width_px = crop.width;
  picture.height_px = crop.height;
  picture.colours.resize(static_cast<std::size_t>(crop.width * crop.height));
  for (const Run& run : map.runs) {
    const auto first = picture.colours.begin() + (run.row - crop.y) * crop.width - crop.x;
    std::fill(first + run.begin, first + run.end,
              static_cast<std::uint8_t>(number_of_label[run.label]));
  }
  return picture;
}

PalettePicture thinned_out(const PalettePicture& picture, int longer_side_px) {
  const int side = std::max(picture.width_px, picture.height_px);
  const int step = (side + longer_side_px - 1) / longer_side_px;
  if (step <= 1) return picture;
  PalettePicture small;
  small.palette = picture.palette;
  small.width_px = (picture.width_px + step - 1) / step;
  small.height_px = (picture.height_px + step - 1) / step;
  for (int y = 0; y < picture.height_px; y += step)
    for (int x = 0; x < picture.width_px; x += step)
      small.colours.push_back(picture.colours[static_cast<std::size_t>(y * picture.width_px + x)]);
  return small;
}

std::optional<GoldenFrame> encode_golden_frame(const PalettePicture& picture) {
  GoldenFrame golden;
  golden.width_px = picture.width_px;
  golden.height_px = picture.height_px;
  golden.palette = picture.palette;
  BitWriter bits(golden.rows);
  GoldenRow above;
  for (int y = 0; y < picture.height_px; ++y) {
    GoldenRow row = runs_of(picture.colours.data() + y * picture.width_px, picture.width_px);
    if (row.size() > kMaxGoldenRuns) return std::nullopt;
    if (same_colours(above, row))
      write_moved(above, row, bits);
    else
      write_anew(row, bits);
    above = std::move(row);
  }
  return golden;
}

}  // namespace aspect
