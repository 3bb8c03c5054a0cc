#include "runtime/capture/raw_frames.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <system_error>

#include "runtime/capture/picture_header.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

struct NamedFormat {
  std::string_view fourcc;
  PixelFormat format;
};

// Linux, Documentation/userspace-api/media/v4l/pixfmt*.rst
constexpr std::array<NamedFormat, 13> kFormats = {{{"YUYV", PixelFormat::yuyv8},
                                                   {"UYVY", PixelFormat::uyvy8},
                                                   {"NV12", PixelFormat::nv12},
                                                   {"NV21", PixelFormat::nv21},
                                                   {"RGB3", PixelFormat::rgb8},
                                                   {"BGR3", PixelFormat::bgr8},
                                                   {"XB24", PixelFormat::rgbx8},
                                                   {"XR24", PixelFormat::bgrx8},
                                                   {"GREY", PixelFormat::grey8},
                                                   {"RGGB", PixelFormat::bayer_rggb8},
                                                   {"GRBG", PixelFormat::bayer_grbg8},
                                                   {"GBRG", PixelFormat::bayer_gbrg8},
                                                   {"BA81", PixelFormat::bayer_bggr8}}};

const NamedFormat* find_format(std::string_view fourcc) {
  const auto* found = std::find_if(kFormats.begin(), kFormats.end(),
                                   [&](const NamedFormat& f) { return f.fourcc == fourcc; });
  return found == kFormats.end() ? nullptr : found;
}

// The last two parts of NAME.WIDTHxHEIGHT.FOURCC; empty where there are not as many.
struct NameParts {
  std::string_view size, fourcc;
};

NameParts parts_of(std::string_view path) {
  const std::string_view name = path.substr(path.rfind('/') + 1);
  const std::size_t last = name.rfind('.');
  if (last == std::string_view::npos) return {};
  const std::string_view stem = name.substr(0, last);
  const std::size_t first = stem.rfind('.');
  return {first == std::string_view::npos ? std::string_view() : stem.substr(first + 1),
          name.substr(last + 1)};
}

struct Size {
  int width_px = 0, height_px = 0;
};

std::optional<Size> size_of(std::string_view text) {
  Size size;
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width_px);
  if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return std::nullopt;
  const auto height = std::from_chars(width.ptr + 1, end, size.height_px);
  if (height.ec != std::errc() || height.ptr != end) return std::nullopt;
  return size;
}

std::optional<std::string> evenness_fault(const RawFormat& raw, std::string_view fourcc) {
  if (has_even_width(raw.format) && raw.width_px % 2 != 0)
    return fmt::format("{} frames have an even width, not {}; mend the name", fourcc, raw.width_px);
  if (has_even_height(raw.format) && raw.height_px % 2 != 0)
    return fmt::format("{} frames have an even height, not {}; mend the name", fourcc,
                       raw.height_px);
  return std::nullopt;
}

std::size_t bytes_of(const RawFormat& raw) {
  return frame_bytes(raw.format, raw.width_px, raw.height_px);
}

}  // namespace

bool is_raw_name(const fs::path& file) {
  constexpr std::size_t kFourccLetters = 4;
  const NameParts parts = parts_of(file.native());
  return find_format(parts.fourcc) != nullptr ||
         (parts.fourcc.size() == kFourccLetters && size_of(parts.size));
}

Result<RawFormat> raw_format_of(const fs::path& file) {
  const NameParts parts = parts_of(file.native());
  const auto size = size_of(parts.size);
  if (!size)
    return Error{"the name does not say the size of raw frames; call it NAME.WIDTHxHEIGHT." +
                 std::string(parts.fourcc)};
  const NamedFormat* named = find_format(parts.fourcc);
  if (named == nullptr) {
    std::string known;
    for (const NamedFormat& format : kFormats) known.append(" ").append(format.fourcc);
    return Error{fmt::format("{} is no format of raw frames that is read; give one of{}",
                             parts.fourcc, known)};
  }
  if (auto fault = size_fault(size->width_px, size->height_px)) return Error{*fault};
  const RawFormat raw{size->width_px, size->height_px, named->format};
  if (auto fault = evenness_fault(raw, named->fourcc)) return Error{*fault};
  return raw;
}

std::size_t raw_frame_count(const fs::path& file) {
  const Result<RawFormat> raw = raw_format_of(file);
  if (!raw) return 1;
  const std::uint64_t bytes = InputFile(file).size().value_or(0);
  if (bytes == 0 || bytes % bytes_of(raw.value()) != 0) return 1;
  return static_cast<std::size_t>(bytes / bytes_of(raw.value()));
}

RawFrames::RawFrames(fs::path file, SensorKind sensor) : file_(std::move(file)), sensor_(sensor) {}

std::optional<std::string> RawFrames::open() {
  const Result<RawFormat> raw = raw_format_of(file_);
  if (!raw) return raw.error();
  format_ = raw.value();
  if (!gives(sensor_, format_.format))
    return fmt::format(
        "not frames of a {} sensor; give frames of that sensor, or an index of this one's",
        name_of(sensor_));
  input_.emplace(file_);
  const auto bytes = input_->size();
  if (!bytes) return fmt::format("cannot be read ({}); check its permissions", input_->reason());
  if (*bytes == 0) return "an empty file; copy or record it again";
  count_ = *bytes / bytes_of(format_);
  if (*bytes % bytes_of(format_) != 0)
    return fmt::format(
        "{} bytes are {} frames of {} and {} bytes more; mend the name, or copy or record it again",
        *bytes, count_, bytes_of(format_), *bytes % bytes_of(format_));
  return std::nullopt;
}

FrameStatus RawFrames::next(CapturedFrame& frame) {
  if (ended_) return FrameStatus::end;
  std::optional<std::string> fault;
  frame.name = file_.native();
  if (!input_) fault = open();
  if (!fault && next_ == count_) {
    ended_ = true;
    input_.reset();
    return FrameStatus::end;
  }
  if (!fault) {
    frame.name.append("#").append(std::to_string(next_));
    frame.width_px = format_.width_px;
    frame.height_px = format_.height_px;
    frame.format = format_.format;
    frame.pixels.resize(bytes_of(format_));
    if (!input_->read(frame.pixels)) fault = "became shorter while it was read; copy it again";
    ++next_;
  }
  if (!fault) return FrameStatus::frame;
  ended_ = true;
  frame.error = file_.native() + ": " + *fault;
  return FrameStatus::failed;
}

}  // namespace aspect
