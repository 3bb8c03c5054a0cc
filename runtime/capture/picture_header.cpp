// PNG: chunks are walked to IEND, so that a file that ends early is seen whatever its decoder would
// make of it. JPEG: segments are walked to the frame header and the first scan; a file whose scan
// data never meet an end-of-image marker was cut off. Contents are not looked at, checksums
// neither.
#include "runtime/capture/picture_header.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#include "runtime/vision/vision_limits.h"

namespace aspect {
namespace {

constexpr const char* kCutOff = "cut off before the picture's end; copy or record it again";

// Big-endian numbers at any place; beyond the end they read as 0, and ok() remembers.
class Bytes {
 public:
  explicit Bytes(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::uint32_t at(std::size_t place) {
    if (place < bytes_.size()) return std::to_integer<std::uint32_t>(bytes_[place]);
    ok_ = false;
    return 0;
  }
  std::uint32_t big16(std::size_t place) { return at(place) << 8U | at(place + 1); }
  std::uint32_t big32(std::size_t place) { return big16(place) << 16U | big16(place + 2); }
  std::uint32_t little32(std::size_t place) {
    return at(place) | at(place + 1) << 8U | at(place + 2) << 16U | at(place + 3) << 24U;
  }
  bool ok() const { return ok_; }
  std::size_t size() const { return bytes_.size(); }
  bool begins_with(std::span<const std::uint8_t> magic) const {
    const auto same = [](std::byte a, std::uint8_t b) { return a == std::byte{b}; };
    return bytes_.size() >= magic.size() &&
           std::equal(magic.begin(), magic.end(), bytes_.begin(),
                      [&](std::uint8_t b, std::byte a) { return same(a, b); });
  }

 private:
  std::span<const std::byte> bytes_;
  bool ok_ = true;
};

constexpr std::array<std::uint8_t, 8> kPng = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::array<std::uint8_t, 3> kJpeg = {0xFF, 0xD8, 0xFF};
constexpr std::array<std::uint8_t, 2> kBmp = {'B', 'M'};

std::optional<std::string> png_fault(Bytes bytes) {
  constexpr std::uint32_t kEnd = 0x49454E44;  // IEND
  const std::uint32_t width = bytes.big32(16), height = bytes.big32(20);
  if (!bytes.ok()) return kCutOff;
  if (auto fault = size_fault(width, height)) return fault;
  for (std::size_t chunk = kPng.size();;) {
    const std::uint32_t length = bytes.big32(chunk), type = bytes.big32(chunk + 4);
    chunk += 12 + std::size_t{length};
    if (!bytes.ok() || chunk > bytes.size()) return kCutOff;
    if (type == kEnd) return std::nullopt;
  }
}

// Frame headers are C0 to CF but for the three that hold tables.
bool is_frame_header(std::uint32_t marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

std::optional<std::string> jpeg_fault(Bytes bytes) {
  constexpr std::uint32_t kScan = 0xDA, kEndOfImage = 0xD9;
  std::size_t place = 2;
  for (std::uint32_t marker = 0; marker != kScan;) {
    while (bytes.at(place) == 0xFF && bytes.at(place + 1) == 0xFF) ++place;
    if (bytes.at(place) != 0xFF && bytes.ok())
      return "damaged: a JPEG marker is missing; copy or record it again";
    marker = bytes.at(place + 1);
    if (is_frame_header(marker))
      if (auto fault = size_fault(bytes.big16(place + 7), bytes.big16(place + 5)))
        return bytes.ok() ? fault : kCutOff;
    place += 2 + bytes.big16(place + 2);
    if (!bytes.ok()) return kCutOff;
  }
  // Within scan data a byte FF is followed by 0 or by a restart marker.
  for (; place + 1 < bytes.size(); ++place)
    if (bytes.at(place) == 0xFF && bytes.at(place + 1) == kEndOfImage) return std::nullopt;
  return kCutOff;
}

std::optional<std::string> bmp_fault(Bytes bytes) {
  constexpr std::uint32_t kInfoHeaderBytes = 40;
  if (bytes.little32(14) < kInfoHeaderBytes) return std::nullopt;
  const auto width = static_cast<std::int32_t>(bytes.little32(18));
  const auto height = static_cast<std::int32_t>(bytes.little32(22));
  if (!bytes.ok()) return kCutOff;
  // A negative height says that the rows come from top to bottom.
  return size_fault(width, std::abs(std::int64_t{height}));
}

}  // namespace

bool is_deep_grey_png(std::span<const std::byte> file) {
  constexpr std::uint32_t kSixteenBits = 16, kGrey = 0;
  Bytes bytes(file);
  return bytes.begins_with(kPng) && bytes.at(24) == kSixteenBits && bytes.at(25) == kGrey &&
         bytes.ok();
}

std::optional<std::string> size_fault(std::int64_t width_px, std::int64_t height_px) {
  if (width_px < kMinFrameSide_px || height_px < kMinFrameSide_px)
    return fmt::format(
        "{} x {} px; nothing can be seen in less than {} px a side, give another picture", width_px,
        height_px, kMinFrameSide_px);
  if (width_px > kMaxFrameSide_px || height_px > kMaxFrameSide_px)
    return fmt::format("{} x {} px; at most {} px a side can be looked at, scale it down", width_px,
                       height_px, kMaxFrameSide_px);
  if (width_px * height_px > kMaxFramePixels)
    return fmt::format("{} x {} px; at most {} megapixels can be looked at, scale it down",
                       width_px, height_px, kMaxFramePixels / 1'000'000);
  return std::nullopt;
}

std::optional<std::string> picture_fault(std::span<const std::byte> file) {
  const Bytes bytes(file);
  if (bytes.begins_with(kPng)) return png_fault(bytes);
  if (bytes.begins_with(kJpeg)) return jpeg_fault(bytes);
  if (bytes.begins_with(kBmp)) return bmp_fault(bytes);
  return std::nullopt;
}

}  // namespace aspect
