// Frames that are transparent in places: each beside the colours that must come of it.
#include <png.h>
#include <zlib.h>
#include <array>
#include <catch2/catch.hpp>

#include "runtime/capture/recorded_frames.h"
#include "tests/runtime/capture/sample_pictures.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

constexpr int kWidth_px = 80, kHeight_px = 64;
const cv::Vec3b kObject(60, 180, 240), kHidden(250, 240, 30);  // blue first

// Opaque in a rectangle, transparent around it, half so in the rectangle's first column.
int alpha_at(int x, int y) {
  if (x < 8 || x >= 24 || y < 4 || y >= 60) return 0;
  return x == 8 ? 128 : 255;
}

cv::Mat transparent_picture(int channels) {
  cv::Mat picture(kHeight_px, kWidth_px, CV_8UC(channels));
  for (int y = 0; y < kHeight_px; ++y)
    for (int x = 0; x < kWidth_px; ++x) {
      const int alpha = alpha_at(x, y);
      const cv::Vec3b& colour = alpha > 0 ? kObject : kHidden;
      auto* pixel = picture.ptr(y, x);
      if (channels > 2) std::copy_n(colour.val, 3, pixel);
      if (channels <= 2) pixel[0] = alpha > 0 ? 200 : 255;
      if (channels % 2 == 0) pixel[channels - 1] = static_cast<std::uint8_t>(alpha);
    }
  return picture;
}

CapturedFrame read(const std::string& bytes, SensorKind sensor = SensorKind::colour) {
  const TemporaryFolder folder;
  RecordedFrames frames(std::array{folder.write("a.png", bytes)}, sensor);
  CapturedFrame frame;
  const FrameStatus status = frames.next(frame);
  INFO(frame.error);
  REQUIRE(status == FrameStatus::frame);
  return frame;
}

// `at(x, y)` is the pixel that should be there.
template <typename At>
void require_pixels(const CapturedFrame& frame, At at) {
  REQUIRE(frame.width_px * frame.height_px == kWidth_px * kHeight_px);
  const auto channels = static_cast<std::size_t>(bytes_per_pixel(frame.format));
  for (int y = 0; y < frame.height_px; ++y)
    for (int x = 0; x < frame.width_px; ++x) {
      const std::size_t first = channels * static_cast<std::size_t>(y * frame.width_px + x);
      const cv::Vec3b expected = at(x, y);
      for (std::size_t c = 0; c < channels; ++c) {
        INFO(x << ", " << y << ", channel " << c);
        REQUIRE(std::abs(frame.pixels[first + c] - expected[static_cast<int>(c)]) <= 1);
      }
    }
}

cv::Vec3b scaled(const cv::Vec3b& colour, int alpha) {
  cv::Vec3b result;
  for (int c = 0; c < 3; ++c)
    result[c] = static_cast<std::uint8_t>(std::lround(colour[c] * alpha / 255.));
  return result;
}

cv::Vec3b object_on_black(int x, int y) {
  return scaled(kObject, alpha_at(x, y));
}
cv::Vec3b grey_on_black(int x, int y) {
  return scaled({200, 200, 200}, alpha_at(x, y));
}
// Where transparency is all or nothing.
cv::Vec3b whole_object_on_black(int x, int y) {
  return alpha_at(x, y) > 0 ? kObject : cv::Vec3b();
}

std::string big32(std::size_t value) {
  std::string bytes;
  for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(value >> shift & 255U);
  return bytes;
}

// With one more chunk behind the header.
std::string with_chunk(std::string png, const std::string& type, const std::string& data) {
  const std::string checked = type + data;
  const auto* bytes = reinterpret_cast<const Bytef*>(checked.data());
  const auto sum = crc32(0, bytes, static_cast<uInt>(checked.size()));
  return png.insert(33, big32(data.size()) + checked + big32(sum));
}

// By libpng: of pixels as `format` says.
std::string libpng_file(std::uint32_t format, const void* pixels, const void* colours = nullptr,
                        std::uint32_t colour_count = 0) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = kWidth_px;
  image.height = kHeight_px;
  image.format = format;
  image.colormap_entries = colour_count;
  std::string bytes(1 << 20, '\0');
  png_alloc_size_t size = bytes.size();
  REQUIRE(png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels, 0, colours) != 0);
  bytes.resize(size);
  return bytes;
}

}  // namespace

TEST_CASE("What an alpha channel hides is background in frames of every format that has one") {
  for (const char* ending : {".png", ".tiff", ".webp", ".jp2"}) {
    INFO(ending);
    std::string bytes = encoded(transparent_picture(4), ending);
    if (std::string(ending) == ".webp" || std::string(ending) == ".jp2") {
      std::vector<unsigned char> lossless;
      cv::imencode(ending, transparent_picture(4), lossless,
                   {cv::IMWRITE_WEBP_QUALITY, 101, cv::IMWRITE_JPEG2000_COMPRESSION_X1000, 1000});
      bytes.assign(lossless.begin(), lossless.end());
    }
    require_pixels(read(bytes), object_on_black);
  }
  cv::Mat deep;
  transparent_picture(4).convertTo(deep, CV_16U, 257);
  for (const char* ending : {".png", ".tiff"}) {
    INFO("16 bits, " << ending);
    require_pixels(read(encoded(deep, ending)), object_on_black);
  }
}

TEST_CASE("A grey picture with an alpha channel has its background, for colour and grey sensors") {
  const std::string file = libpng_file(PNG_FORMAT_GA, transparent_picture(2).data);
  REQUIRE(file[25] == PNG_COLOR_TYPE_GRAY_ALPHA);
  require_pixels(read(file), grey_on_black);
  require_pixels(read(file, SensorKind::grey), grey_on_black);
  require_pixels(read(encoded(transparent_picture(4), ".png"), SensorKind::grey), [](int x, int y) {
    const double grey = .114 * kObject[0] + .587 * kObject[1] + .299 * kObject[2];
    const auto level = static_cast<std::uint8_t>(std::lround(grey));
    return scaled({level, level, level}, alpha_at(x, y));
  });
}

TEST_CASE("A palette's transparent colours are background") {
  const std::array<std::uint8_t, 12> colours = {kHidden[2], kHidden[1], kHidden[0], 0,
                                                kObject[2], kObject[1], kObject[0], 255,
                                                kObject[2], kObject[1], kObject[0], 128};
  std::vector<std::uint8_t> indices;
  for (int k = 0; k < kWidth_px * kHeight_px; ++k) {
    const int alpha = alpha_at(k % kWidth_px, k / kWidth_px);
    indices.push_back(alpha == 0 ? 0 : alpha == 255 ? 1 : 2);
  }
  const std::string file = libpng_file(PNG_FORMAT_RGBA_COLORMAP, indices.data(), colours.data(), 3);
  REQUIRE(file[25] == PNG_COLOR_TYPE_PALETTE);
  require_pixels(read(file), object_on_black);
}

TEST_CASE("The one colour or grey that a PNG picture calls transparent is background") {
  const std::string colour_key = {0, static_cast<char>(kHidden[2]),
                                  0, static_cast<char>(kHidden[1]),
                                  0, static_cast<char>(kHidden[0])};
  require_pixels(read(with_chunk(encoded(transparent_picture(3), ".png"), "tRNS", colour_key)),
                 whole_object_on_black);
  const std::string grey =
      with_chunk(encoded(transparent_picture(1), ".png"), "tRNS", std::string("\0\xff", 2));
  for (const SensorKind sensor : {SensorKind::colour, SensorKind::grey})
    require_pixels(read(grey, sensor), [](int x, int y) {
      return alpha_at(x, y) > 0 ? cv::Vec3b(200, 200, 200) : cv::Vec3b();
    });
}

TEST_CASE("A depth that a PNG picture calls transparent is none") {
  cv::Mat depths(kHeight_px, kWidth_px, CV_16UC1, cv::Scalar(1000));
  depths.at<std::uint16_t>(0, 1) = 515;
  const CapturedFrame frame =
      read(with_chunk(encoded(depths, ".png"), "tRNS", std::string("\2\3", 2)), SensorKind::range);
  const auto* steps = reinterpret_cast<const std::uint16_t*>(frame.pixels.data());
  CHECK(steps[0] == 1000);
  CHECK(steps[1] == 0);
}

TEST_CASE("Transparency is turned with the picture") {
  // Orientation 6: the first row is the right side, the first column the top.
  const std::string exif("MM\0*\0\0\0\10\0\1\1\22\0\3\0\0\0\1\0\6\0\0\0\0\0\0", 26);
  const CapturedFrame frame =
      read(with_chunk(encoded(transparent_picture(4), ".png"), "eXIf", exif));
  CHECK(frame.width_px == kHeight_px);
  require_pixels(frame, [](int x, int y) { return object_on_black(y, kHeight_px - 1 - x); });
}

TEST_CASE("A Windows bitmap's fourth byte counts where the file says that it is alpha") {
  const auto bitmap = [](bool says) {
    std::string bytes = "BM" + std::string(12, '\0');
    const auto little = [&](std::uint32_t value, int count) {
      for (int k = 0; k < count; ++k) bytes += static_cast<char>(value >> 8 * k & 255U);
    };
    bytes[10] = says ? 14 + 108 : 14 + 40;
    little(says ? 108 : 40, 4), little(kWidth_px, 4), little(kHeight_px, 4), little(1, 2);
    little(32, 2), little(says ? 3 : 0, 4);
    for (int k = 0; k < 5; ++k) little(0, 4);
    if (says)
      for (const std::uint32_t mask : {0xff0000U, 0xff00U, 0xffU, 0xff000000U}) little(mask, 4);
    bytes.resize(static_cast<std::size_t>(bytes[10]), '\0');
    const cv::Mat picture = transparent_picture(4);
    for (int y = kHeight_px - 1; y >= 0; --y)
      bytes.append(reinterpret_cast<const char*>(picture.ptr(y)), std::size_t{kWidth_px} * 4);
    return bytes;
  };
  require_pixels(read(bitmap(true)), object_on_black);
  require_pixels(read(bitmap(false)),
                 [](int x, int y) { return alpha_at(x, y) > 0 ? kObject : kHidden; });
}

}  // namespace aspect
