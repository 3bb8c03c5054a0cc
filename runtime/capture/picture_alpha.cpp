// PNG has transparency in five ways (grey or colours with an alpha channel, palettes with alphas,
// one grey or colour that stands for nothing), of which OpenCV 4.6 leaves out that of a grey:
// libpng knows them all. Of other formats it is OpenCV's fourth channel.
#include "runtime/capture/picture_alpha.h"

#include <png.h>
#include <algorithm>
#include <array>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <vector>

namespace aspect {
namespace {

constexpr const char* kDamaged = "its transparency is damaged; copy or record it again";

bool begins_with(std::span<const std::byte> file, std::string_view magic) {
  return file.size() >= magic.size() &&
         std::equal(magic.begin(), magic.end(), file.begin(), [](char a, std::byte b) {
           return static_cast<std::uint8_t>(a) == std::to_integer<std::uint8_t>(b);
         });
}

bool is_png(std::span<const std::byte> file) {
  return begins_with(file, "\x89PNG");
}

bool never_transparent(std::span<const std::byte> file) {
  if (begins_with(file, "\xFF\xD8")) return true;  // JPEG
  const bool pnm = file.size() > 1 && begins_with(file, "P");
  return pnm && file[1] >= std::byte{'1'} && file[1] <= std::byte{'6'};
}

cv::Mat encoded(std::span<const std::byte> file) {
  return {1, static_cast<int>(file.size()), CV_8UC1, const_cast<std::byte*>(file.data())};
}

// The whole chunk that says how a picture is turned; empty where there is none. The file has been
// walked to its end: picture_fault().
std::span<const std::byte> exif_chunk(std::span<const std::byte> png) {
  const auto big32 = [&](std::size_t place) {
    std::size_t value = 0;
    for (std::size_t k = 0; k < 4; ++k)
      value = value << 8U | std::to_integer<std::size_t>(png[place + k]);
    return value;
  };
  for (std::size_t chunk = 8; chunk + 12 <= png.size();) {
    const std::size_t bytes = big32(chunk) + 12;
    if (bytes > png.size() - chunk) break;
    if (begins_with(png.subspan(chunk + 4), "eXIf")) return png.subspan(chunk, bytes);
    chunk += bytes;
  }
  return {};
}

// As OpenCV turns colours: it does so with a picture that has the same chunk.
cv::Mat turned(const cv::Mat& alpha, std::span<const std::byte> exif) {
  constexpr std::ptrdiff_t kBehindHeader = 8 + 25;
  std::vector<std::uint8_t> file;
  cv::imencode(".png", alpha, file);
  const auto* chunk = reinterpret_cast<const std::uint8_t*>(exif.data());
  file.insert(file.begin() + kBehindHeader, chunk, chunk + exif.size());
  return cv::imdecode(file, cv::IMREAD_GRAYSCALE);
}

// Empty where nothing is transparent.
std::optional<std::string> read_png_alpha(std::span<const std::byte> file, cv::Mat& alpha) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, file.data(), file.size()) == 0) return kDamaged;
  if ((image.format & PNG_FORMAT_FLAG_ALPHA) == 0) {
    png_image_free(&image);
    return std::nullopt;
  }
  image.format = PNG_FORMAT_GA;
  cv::Mat grey_alpha(static_cast<int>(image.height), static_cast<int>(image.width), CV_8UC2);
  if (png_image_finish_read(&image, nullptr, grey_alpha.data, 0, nullptr) == 0) return kDamaged;
  cv::extractChannel(grey_alpha, alpha, 1);
  if (const auto exif = exif_chunk(file); !exif.empty()) alpha = turned(alpha, exif);
  return std::nullopt;
}

// Likewise.
cv::Mat fourth_channel(std::span<const std::byte> file) {
  const cv::Mat all = cv::imdecode(encoded(file), cv::IMREAD_UNCHANGED);
  cv::Mat alpha;
  if (all.channels() != 4) return alpha;
  cv::extractChannel(all, alpha, 3);
  const double scale = all.depth() == CV_8U ? 1 : all.depth() == CV_16U ? 1 / 257. : 255;
  alpha.convertTo(alpha, CV_8U, scale);
  return alpha;
}

void blacken_row(const std::uint8_t* alpha, cv::Mat& picture, int y) {
  const int channels = picture.channels();
  if (picture.depth() == CV_16U) {
    auto* row = picture.ptr<std::uint16_t>(y);
    for (int x = 0; x < picture.cols; ++x)
      if (alpha[x] == 0) row[x] = 0;
    return;
  }
  auto* row = picture.ptr<std::uint8_t>(y);
  for (int k = 0; k < picture.cols * channels; ++k)
    row[k] = static_cast<std::uint8_t>((row[k] * alpha[k / channels] + 127) / 255);
}

}  // namespace

std::optional<std::string> blacken_transparent(std::span<const std::byte> file, cv::Mat& picture) {
  if (never_transparent(file)) return std::nullopt;
  cv::Mat alpha;
  if (!is_png(file))
    alpha = fourth_channel(file);
  else if (auto fault = read_png_alpha(file, alpha))
    return fault;
  if (alpha.empty()) return std::nullopt;
  if (alpha.size() != picture.size()) return kDamaged;
  for (int y = 0; y < picture.rows; ++y) blacken_row(alpha.ptr<std::uint8_t>(y), picture, y);
  return std::nullopt;
}

}  // namespace aspect
