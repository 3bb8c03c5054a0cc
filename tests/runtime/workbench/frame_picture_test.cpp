#include "runtime/workbench/frame_picture.h"

#include <catch2/catch.hpp>
#include <cstring>

namespace aspect {
namespace {

struct Made {
  PixelFormat format;
  std::vector<std::uint8_t> bytes, chroma{};  // of 2 x 2 pixels of one colour

  Frame frame() const {
    return {bytes.data(),
            2,
            2,
            static_cast<std::ptrdiff_t>(bytes.size() / 2),
            format,
            chroma.empty() ? nullptr : chroma.data(),
            2,
            {}};
  }
};

bool near(std::array<std::uint8_t, 3> a, std::array<int, 3> b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (std::abs(a[k] - b[k]) > 2) return false;
  return true;
}

}  // namespace

TEST_CASE("pure red is red in every format") {
  // BT.601, limited range: Y 81, U 90, V 240 (ITU-R BT.601, 100 % bars).
  const std::array<int, 3> red = {255, 0, 0};
  const std::vector<Made> all = {
      Made{PixelFormat::rgb8, {255, 0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0}},
      Made{PixelFormat::bgr8, {0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0, 255}},
      Made{PixelFormat::rgbx8, {255, 0, 0, 9, 255, 0, 0, 9, 255, 0, 0, 9, 255, 0, 0, 9}},
      Made{PixelFormat::bgrx8, {0, 0, 255, 9, 0, 0, 255, 9, 0, 0, 255, 9, 0, 0, 255, 9}},
      Made{PixelFormat::yuyv8, {81, 90, 81, 240, 81, 90, 81, 240}},
      Made{PixelFormat::uyvy8, {90, 81, 240, 81, 90, 81, 240, 81}},
      Made{PixelFormat::nv12, {81, 81, 81, 81}, {90, 240}},
      Made{PixelFormat::nv21, {81, 81, 81, 81}, {240, 90}},
      Made{PixelFormat::bayer_rggb8, {255, 0, 0, 0}},
      Made{PixelFormat::bayer_grbg8, {0, 255, 0, 0}},
      Made{PixelFormat::bayer_gbrg8, {0, 0, 255, 0}},
      Made{PixelFormat::bayer_bggr8, {0, 0, 0, 255}}};
  for (const Made& made : all) {
    INFO(static_cast<int>(made.format));
    for (const int pixel : {0, 1, 2, 3})
      CHECK(near(preview_rgb(made.frame(), pixel % 2, pixel / 2), red));
  }
}

TEST_CASE("a picture is scaled into its bounds and keeps its shape") {
  struct Case {
    int width_px, height_px, shown_width_px, shown_height_px;
  };
  for (const Case& size : {Case{640, 480, 320, 240}, Case{1280, 720, 320, 180},
                           Case{480, 640, 180, 240}, Case{33, 21, 33, 21}, Case{4000, 2, 320, 1}}) {
    INFO(size.width_px);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size.width_px * size.height_px) * 3);
    // The right half is blue.
    for (std::size_t k = 0; k < bytes.size() / 3; ++k)
      bytes[3 * k + 2] = static_cast<int>(k) % size.width_px >= size.width_px / 2 ? 200 : 0;
    const Frame frame{bytes.data(), size.width_px, size.height_px, size.width_px * 3,
                      PixelFormat::rgb8};
    const std::string bmp =
        bitmap_of(frame, size_within({size.width_px, size.height_px}, {320, 240}));
    std::int32_t width = 0, height = 0;
    std::memcpy(&width, bmp.data() + 18, 4);
    std::memcpy(&height, bmp.data() + 22, 4);
    CHECK(width == size.shown_width_px);
    CHECK(height == -size.shown_height_px);
    const auto row = static_cast<std::size_t>((width * 3 + 3) / 4 * 4);
    REQUIRE(bmp.size() == 54 + row * static_cast<std::size_t>(-height));
    const char* const last_row = bmp.data() + bmp.size() - row;
    CHECK(last_row[0] == 0);
    CHECK(static_cast<unsigned char>(last_row[3 * (width - 1)]) == 200);
  }
}

}  // namespace aspect
