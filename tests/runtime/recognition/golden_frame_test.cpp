// The coding of golden frames: what is written is read again, and what was not is refused.
#include "runtime/recognition/golden_frame.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <random>

#include "compiler/index/golden_picture.h"

namespace aspect {
namespace {

std::size_t pixel_bytes(SensorKind sensor) {
  return static_cast<std::size_t>(bytes_per_pixel(golden_format(sensor)));
}

// Rectangles and discs of random colours over each other.
PalettePicture random_picture(std::mt19937& random, SensorKind sensor) {
  PalettePicture picture;
  const auto below = [&](int most) {
    return static_cast<int>(random() % static_cast<unsigned>(most));
  };
  picture.width_px = 1 + below(90);
  picture.height_px = 1 + below(90);
  const int colours = 1 + below(20);
  for (std::size_t k = 0; k < static_cast<std::size_t>(colours) * pixel_bytes(sensor); ++k)
    picture.palette.push_back(static_cast<std::uint8_t>(random()));
  picture.colours.resize(static_cast<std::size_t>(picture.width_px * picture.height_px));
  for (int shape = below(12); shape-- > 0;) {
    const int x0 = below(picture.width_px), y0 = below(picture.height_px), size = below(40);
    const bool is_disc = below(2) == 0;
    const auto colour = static_cast<std::uint8_t>(below(colours + 1));
    for (int y = 0; y < picture.height_px; ++y)
      for (int x = 0; x < picture.width_px; ++x) {
        const int dx = std::abs(x - x0), dy = std::abs(y - y0);
        if (is_disc ? dx * dx + dy * dy <= size * size : std::max(dx, dy) <= size)
          picture.colours[static_cast<std::size_t>(y * picture.width_px + x)] = colour;
      }
  }
  return picture;
}

// Pixel by pixel from the palette.
std::vector<std::uint8_t> plain_pixels(const PalettePicture& picture, SensorKind sensor) {
  std::vector<std::uint8_t> pixels;
  for (const std::uint8_t colour : picture.colours)
    for (std::size_t k = 0; k < pixel_bytes(sensor); ++k)
      pixels.push_back(colour == 0 ? std::uint8_t{0}
                                   : picture.palette[(colour - 1U) * pixel_bytes(sensor) + k]);
  return pixels;
}

// Into memory of just its size: the sanitizers see what lies behind.
std::vector<std::uint8_t> decoded(const GoldenFrame& golden, SensorKind sensor) {
  std::vector<std::uint8_t> pixels(golden_picture_bytes(golden, sensor), 0xAA);
  const Frame frame = decode_golden_frame(golden, sensor, pixels);
  CHECK((frame.width_px == golden.width_px && frame.height_px == golden.height_px));
  CHECK(gives(sensor, frame.format));
  return pixels;
}

// A cube's corner, roughly: straight borders of all slopes.
PalettePicture straight_borders(int side_px) {
  PalettePicture picture{side_px, side_px, {1, 2, 3, 4, 5, 6, 7, 8, 9}, {}};
  for (int y = 0; y < side_px; ++y)
    for (int x = 0; x < side_px; ++x)
      picture.colours.push_back(2 * x + 3 * y < 2 * side_px ? 0
                                : 5 * x < 4 * y             ? 1
                                : x + 7 * y < 6 * side_px   ? 2
                                                            : 3);
  return picture;
}

}  // namespace

TEST_CASE("a picture is the same after coding and decoding, of every sensor that has them") {
  std::mt19937 random(1);
  for (const SensorKind sensor : {SensorKind::colour, SensorKind::grey, SensorKind::surface}) {
    for (int round = 0; round < 150; ++round) {
      const PalettePicture picture = random_picture(random, sensor);
      const auto golden = encode_golden_frame(picture);
      REQUIRE(golden);
      REQUIRE(is_sound(*golden, sensor));
      REQUIRE(decoded(*golden, sensor) == plain_pixels(picture, sensor));
    }
  }
}

TEST_CASE("straight borders take a few bits a row") {
  const PalettePicture picture = straight_borders(300);
  const auto golden = encode_golden_frame(picture);
  REQUIRE(golden);
  CHECK(decoded(*golden, SensorKind::colour) == plain_pixels(picture, SensorKind::colour));
  CHECK(golden->rows.size() < 300);
}

TEST_CASE("damaged rows are refused, or decoded within the picture") {
  std::mt19937 random(2);
  int refused = 0, taken = 0;
  for (int round = 0; round < 3000; ++round) {
    const auto sensor = static_cast<SensorKind>(round % 2);
    GoldenFrame golden = encode_golden_frame(random_picture(random, sensor)).value();
    for (unsigned k = 0; k <= random() % 4; ++k)
      golden.rows[random() % golden.rows.size()] ^= static_cast<std::uint8_t>(1U << random() % 8);
    if (round % 7 == 0) golden.rows.resize(random() % (golden.rows.size() + 1));
    if (round % 11 == 0) golden.palette.resize(random() % 8);
    if (round % 13 == 0) golden.width_px = static_cast<int>(random() % 8000);
    if (!is_sound(golden, sensor)) {
      ++refused;
      continue;
    }
    ++taken;
    decoded(golden, sensor);
  }
  CHECK(refused > 500);
  CHECK(taken > 100);
}

TEST_CASE("bits that are no picture are refused whatever they say") {
  std::mt19937 random(3);
  for (int round = 0; round < 5000; ++round) {
    GoldenFrame golden{
        1 + static_cast<int>(random() % 300), 1 + static_cast<int>(random() % 300), {9, 9, 9}, {}};
    golden.rows.resize(random() % 60);
    for (std::uint8_t& byte : golden.rows) byte = static_cast<std::uint8_t>(random());
    if (is_sound(golden, SensorKind::colour)) decoded(golden, SensorKind::colour);
  }
  const GoldenFrame good = encode_golden_frame(straight_borders(40)).value();
  REQUIRE(is_sound(good, SensorKind::colour));
  const auto is_refused = [&](auto&& change) {
    GoldenFrame golden = good;
    change(golden);
    return !is_sound(golden, SensorKind::colour);
  };
  CHECK(is_refused([](GoldenFrame& g) { g.width_px = 0; }));
  CHECK(is_refused([](GoldenFrame& g) { g.height_px = 0; }));
  CHECK(is_refused([](GoldenFrame& g) { g.height_px = -1; }));
  CHECK(is_refused([](GoldenFrame& g) { g.height_px = 41; }));
  CHECK(is_refused([](GoldenFrame& g) { g.width_px = g.height_px = 65535; }));
  CHECK(is_refused([](GoldenFrame& g) { g.width_px = 39; }));
  CHECK(is_refused([](GoldenFrame& g) { g.palette.pop_back(); }));
  CHECK(is_refused([](GoldenFrame& g) { g.palette.resize(6); }));
  CHECK(is_refused([](GoldenFrame& g) { g.palette.resize(3 * 256); }));
  CHECK(is_refused([](GoldenFrame& g) { g.rows.clear(); }));
  CHECK(is_refused([](GoldenFrame& g) { g.rows.pop_back(); }));
  CHECK(is_refused([](GoldenFrame& g) { g.rows.push_back(0); }));
  CHECK_FALSE(is_sound(good, SensorKind::range));
  PalettePicture slope{40, 40, {1, 2, 3}, {}};
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) slope.colours.push_back(x <= y ? 1 : 0);
  GoldenFrame leaves_it = encode_golden_frame(slope).value();
  CHECK(is_sound(leaves_it, SensorKind::colour));
  leaves_it.width_px = 39;
  CHECK_FALSE(is_sound(leaves_it, SensorKind::colour));
}

TEST_CASE("a picture whose rows have too many runs is not coded") {
  PalettePicture picture{600, 1, {1, 2, 3, 4, 5, 6}, {}};
  for (int x = 0; x < 600; ++x) picture.colours.push_back(static_cast<std::uint8_t>(1 + x % 2));
  CHECK_FALSE(encode_golden_frame(picture));
}

TEST_CASE("a picture thinned out keeps every step-th pixel, and no side is longer than asked for") {
  std::mt19937 random(4);
  for (int round = 0; round < 150; ++round) {
    const PalettePicture picture = random_picture(random, SensorKind::colour);
    const int most_px = 1 + static_cast<int>(random() % 100);
    const PalettePicture small = thinned_out(picture, most_px);
    const int longer = std::max(picture.width_px, picture.height_px);
    // The least step that does.
    int step = 1;
    while (step * most_px < longer) ++step;
    INFO(picture.width_px << " x " << picture.height_px << " to " << most_px);
    CHECK(std::max(small.width_px, small.height_px) <= most_px);
    CHECK(small.palette == picture.palette);
    std::vector<std::uint8_t> colours;
    int rows = 0;
    for (int y = 0; y < picture.height_px; ++y) {
      if (y % step == 0) ++rows;
      for (int x = 0; x < picture.width_px; ++x)
        if (x % step == 0 && y % step == 0)
          colours.push_back(picture.colours[static_cast<std::size_t>(y * picture.width_px + x)]);
    }
    CHECK(small.height_px == rows);
    CHECK(small.width_px * small.height_px == static_cast<int>(colours.size()));
    CHECK(small.colours == colours);
  }
}

TEST_CASE("a picture that is small enough stays as it is") {
  const PalettePicture picture = straight_borders(40);
  for (const int most_px : {40, 41, 1000}) {
    const PalettePicture same = thinned_out(picture, most_px);
    CHECK((same.width_px == 40 && same.height_px == 40));
    CHECK(same.colours == picture.colours);
    CHECK(same.palette == picture.palette);
  }
  CHECK(thinned_out(picture, 39).width_px == 20);
}

}  // namespace aspect
