// Turns bits into a frame and parameters and checks what must hold of any graph.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <random>
#include <span>
#include <vector>

#include "runtime/base/check.h"
#include "runtime/vision/vision.h"
#include "runtime/vision/vision_limits.h"

#include "tests/rounds.h"

namespace aspect {
namespace {

constexpr int kSide_px = 96;

// Bytes from the input; zeros when there are no more.
class Bits {
 public:
  explicit Bits(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint8_t byte() { return next_ < bytes_.size() ? bytes_[next_++] : std::uint8_t{0}; }
  int below(int end) { return (byte() * 256 + byte()) % end; }
  bool done() const { return next_ >= bytes_.size(); }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

VisionParameters parameters_from(Bits& bits) {
  VisionParameters parameters;
  parameters.intensity_min = bits.below(800) - 10;
  parameters.chroma_step = bits.below(256);
  parameters.noise_steps = bits.below(20);
  parameters.intensity_step = bits.below(800);
  parameters.area_min_px = bits.below(60);
  parameters.thickness_min_px = static_cast<float>(bits.below(12)) / 2;
  const std::uint8_t flags = bits.byte();
  parameters.smooth = (flags & 1U) != 0;
  parameters.one_blob = (flags & 2U) != 0;
  if ((flags & 4U) != 0) parameters.relations_max = bits.below(100);
  if ((flags & 8U) != 0)
    parameters.region_of_interest = {bits.below(200) - 50, bits.below(200) - 50, bits.below(200),
                                     bits.below(200)};
  return parameters;
}

// Boxes of colour over one another, pixels of noise, or both: few bits reach much structure.
std::vector<std::uint8_t> pixels_from(Bits& bits, int width, int height) {
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(3 * width * height));
  while (!bits.done()) {
    const int x0 = bits.below(width), y0 = bits.below(height);
    const int x1 = std::min(width, x0 + 1 + bits.below(width));
    const int y1 = std::min(height, y0 + 1 + bits.below(height));
    const int step_x = 1 + bits.byte() % 3, step_y = 1 + bits.byte() % 3;
    const std::array<std::uint8_t, 3> rgb = {bits.byte(), bits.byte(), bits.byte()};
    for (int y = y0; y < y1; y += step_y)
      for (int x = x0; x < x1; x += step_x)
        std::copy(rgb.begin(), rgb.end(), pixels.begin() + 3 * (y * width + x));
  }
  return pixels;
}

void check_contour(const Contour& contour, const ViewGraph& graph, const RegionMap& map) {
  ASPECT_CHECK(contour.region >= 1 && contour.region <= map.regions.size());
  ASPECT_CHECK(contour.inside <= map.regions.size());
  ASPECT_CHECK(contour.blob < graph.blobs.size());
  ASPECT_CHECK(contour.area_px > 0);
  ASPECT_CHECK(contour.moments.xx >= 0 && contour.moments.yy >= 0);
  int x = contour.start_x, y = contour.start_y;
  for (const std::uint8_t code : contour.chain) {
    ASPECT_CHECK(code < 8);
    x += kStepX[code];
    y += kStepY[code];
    ASPECT_CHECK(map.labels[static_cast<std::size_t>(y * map.stride_px + x)] == contour.region);
  }
  ASPECT_CHECK(x == contour.start_x && y == contour.start_y);
}

void check_graph(const ViewGraph& graph, const RegionMap& map) {
  ASPECT_CHECK(graph.blobs.size() <= static_cast<std::size_t>(kMaxBlobs));
  ASPECT_CHECK(graph.relations.size() <= static_cast<std::size_t>(kMaxRelations));
  for (const Contour& contour : graph.contours) check_contour(contour, graph, map);
  for (const Run& run : map.runs) ASPECT_CHECK(run.label <= map.regions.size());
  for (const Blob& blob : graph.blobs) {
    ASPECT_CHECK(blob.contour_count <= kMaxBlobContours);
    ASPECT_CHECK(blob.area_px > 0 && !blob.box.empty());
  }
}

class PreparedVision {
 public:
  explicit PreparedVision(SensorKind sensor) {
    Arena counting;
    vision_.prepare(counting, kSide_px, kSide_px, sensor);
    lines_.resize((counting.used_bytes() + 63) / 64);
    Arena arena(std::as_writable_bytes(std::span(lines_)));
    vision_.prepare(arena, kSide_px, kSide_px, sensor);
  }
  Vision& vision() { return vision_; }

 private:
  struct alignas(64) CacheLine {
    std::array<std::byte, 64> bytes;
  };
  std::vector<CacheLine> lines_;
  Vision vision_;
};

// The same boxes as a frame of another sensor: red and green are a number of 16 bits, which rises
// along x by some of blue, so that depths slant.
void run_other(SensorKind sensor, PixelFormat format, const std::vector<std::uint8_t>& rgb,
               int width, int height, VisionParameters parameters) {
  static std::array<PreparedVision, 3> prepared = {PreparedVision(SensorKind::grey),
                                                   PreparedVision(SensorKind::range),
                                                   PreparedVision(SensorKind::surface)};
  const int bytes = bytes_per_pixel(format);
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width * height * bytes));
  for (int i = 0; i < width * height; ++i) {
    const std::uint8_t* from = rgb.data() + 3 * i;
    const int slant = sensor == SensorKind::range ? i % width * (from[2] % 16) : 0;
    const auto number = static_cast<std::uint16_t>(from[0] + 256 * from[1] + slant);
    std::memcpy(pixels.data() + bytes * i, &number, static_cast<std::size_t>(bytes));
  }
  parameters.sensor = sensor;
  parameters.range.steps_min = parameters.chroma_step;
  parameters.range.depth_step = 0.001F * static_cast<float>(1 + parameters.noise_steps);
  parameters.range.normal_step_deg = static_cast<float>(1 + parameters.area_min_px);
  parameters.range.field_of_view_deg = static_cast<float>(10 + parameters.area_min_px);
  Vision& vision = prepared[static_cast<std::size_t>(sensor) - 1].vision();
  const ViewGraph graph =
      vision.run({pixels.data(), width, height, std::ptrdiff_t{bytes} * width, format}, parameters);
  check_graph(graph, vision.regions());
}

void run_one(std::span<const std::uint8_t> input) {
  static PreparedVision prepared(SensorKind::colour);
  Bits bits(input);
  const int width = 1 + bits.below(kSide_px), height = 1 + bits.below(kSide_px);
  const VisionParameters parameters = parameters_from(bits);
  const std::vector<std::uint8_t> pixels = pixels_from(bits, width, height);
  const Frame frame{pixels.data(), width, height, 3 * width,
                    input.size() % 2 == 0 ? PixelFormat::rgb8 : PixelFormat::bgr8};
  const ViewGraph graph = prepared.vision().run(frame, parameters);
  check_graph(graph, prepared.vision().regions());
  run_other(SensorKind::grey, PixelFormat::grey8, pixels, width, height, parameters);
  run_other(SensorKind::range, PixelFormat::depth16, pixels, width, height, parameters);
  run_other(SensorKind::surface, PixelFormat::label16, pixels, width, height, parameters);
}

}  // namespace
}  // namespace aspect

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  aspect::run_one({data, size});
  return 0;
}

#ifndef ASPECT_LIBFUZZER
// Without arguments: 4,000 seeded random inputs; otherwise the files named.
int main(int argc, char** argv) {
  if (argc > 1) {
    for (const char* path : std::span(argv, static_cast<std::size_t>(argc)).subspan(1)) {
      std::ifstream file(path, std::ios::binary);
      if (!file) {
        std::fprintf(stderr, "%s: cannot be read\n", path);
        return 1;
      }
      const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
      const std::vector<std::uint8_t> input(bytes.begin(), bytes.end());
      LLVMFuzzerTestOneInput(input.data(), input.size());
    }
    return 0;
  }
  std::mt19937 random(40);
  for (int round = 0; round < aspect::rounds(4000); ++round) {
    std::vector<std::uint8_t> input(random() % (round % 10 == 0 ? 4000 : 300));
    for (std::uint8_t& byte : input) byte = static_cast<std::uint8_t>(random());
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
  return 0;
}
#endif
