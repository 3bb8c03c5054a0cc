#include "runtime/capture/pnm_picture.h"

#include <fmt/format.h>
#include <algorithm>

#include "runtime/base/input_file.h"
#include "runtime/capture/picture_header.h"

namespace aspect {
namespace {

// 16 megapixels of three channels and a generous header.
constexpr std::uintmax_t kMaxFileBytes = 64U << 20U;

constexpr const char* kUnreadable =
    "not a picture that is read here; give binary PPM or PGM, or raw frames, "
    "NAME.WIDTHxHEIGHT.FOURCC";

// The numbers behind the magic, parted by white space and comments from # to the line's end.
class Header {
 public:
  explicit Header(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  // None: no number, or one that no picture has.
  std::optional<int> number() {
    constexpr int kMost = 1'000'000;
    skip_blanks();
    int value = 0, digits = 0;
    for (; place_ < bytes_.size() && bytes_[place_] >= '0' && bytes_[place_] <= '9'; ++place_) {
      value = value * 10 + (bytes_[place_] - '0');
      if (++digits > 6 || value > kMost) return std::nullopt;
    }
    if (digits == 0) return std::nullopt;
    return value;
  }
  // One character of white space ends the header.
  std::span<const std::uint8_t> pixels() const {
    return place_ < bytes_.size() ? bytes_.subspan(place_ + 1) : bytes_.last(0);
  }

 private:
  static bool is_blank(std::uint8_t c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  void skip_blanks() {
    for (; place_ < bytes_.size(); ++place_) {
      if (bytes_[place_] == '#')
        while (place_ + 1 < bytes_.size() && bytes_[place_] != '\n') ++place_;
      else if (!is_blank(bytes_[place_]))
        return;
    }
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t place_ = 2;
};

}  // namespace

std::optional<std::string> parse_pnm(std::span<const std::uint8_t> bytes, SensorKind sensor,
                                     CapturedFrame& frame) {
  if (bytes.empty()) return "an empty file; copy or record it again";
  if (bytes.size() < 3 || bytes[0] != 'P' || (bytes[1] != '5' && bytes[1] != '6'))
    return kUnreadable;
  const bool grey = bytes[1] == '5';
  Header header(bytes);
  const auto width = header.number(), height = header.number(), most = header.number();
  if (!width || !height || !most) return "not a PNM header; give binary PPM or PGM";
  if (auto fault = size_fault(*width, *height)) return fault;
  if (*most != 255)
    return fmt::format("its largest value is {}, not 255; give a picture of 8 bits a channel",
                       *most);
  const bool fits = sensor == SensorKind::colour || (sensor == SensorKind::grey && grey);
  if (!fits)
    return fmt::format("not a {} frame; give a frame of that sensor, or an index of this one's",
                       name_of(sensor));
  const std::size_t count = static_cast<std::size_t>(*width) * static_cast<std::size_t>(*height);
  const std::span<const std::uint8_t> pixels = header.pixels();
  if (pixels.size() < count * (grey ? 1 : 3))
    return "cut off before the picture's end; copy or record it again";
  frame.width_px = *width;
  frame.height_px = *height;
  frame.format = sensor == SensorKind::grey ? PixelFormat::grey8 : PixelFormat::rgb8;
  const bool spreads = grey && sensor == SensorKind::colour;
  frame.pixels.resize(count * (sensor == SensorKind::grey ? 1 : 3));
  for (std::size_t k = 0; k < frame.pixels.size(); ++k)
    frame.pixels[k] = pixels[spreads ? k / 3 : k];
  return std::nullopt;
}

bool read_pnm(const std::filesystem::path& file, SensorKind sensor, CapturedFrame& frame) {
  std::optional<std::string> fault;
  InputFile input(file);
  const std::optional<std::uint64_t> size = input.size();
  if (!size) {
    fault = "cannot be read (" + input.reason() + "); check its permissions";
  } else if (*size > kMaxFileBytes) {
    fault = "larger than 64 MiB; give a smaller picture";
  } else {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(*size));
    fault = input.read(bytes) ? parse_pnm(bytes, sensor, frame)
                              : "cannot be read to its end; copy or record it again";
  }
  if (fault) frame.error = file.native() + ": " + *fault;
  return !fault;
}

}  // namespace aspect
