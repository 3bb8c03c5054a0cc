#include <fmt/format.h>
#include <exception>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <string_view>

#include "runtime/capture/decoders.h"
#include "runtime/capture/mat_frame.h"
#include "runtime/capture/picture_alpha.h"
#include "runtime/capture/picture_header.h"
#include "runtime/capture/stderr_capture.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

// The largest picture with 16 bits in each of four channels, unpacked.
constexpr std::uintmax_t kMaxFileBytes = 512U << 20U;

std::optional<std::string> read_bytes(const fs::path& file, std::vector<std::byte>& bytes) {
  std::error_code code;
  const std::uintmax_t size = fs::file_size(file, code);
  if (code) return "cannot be read: " + code.message() + "; check the path and its permissions";
  if (size == 0) return "an empty file; copy or record it again";
  if (size > kMaxFileBytes) return "larger than 512 MiB; give a smaller picture";
  bytes.resize(size);
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!stream) return "cannot be read; check its permissions";
  return std::nullopt;
}

// libjpeg reports damage only as a warning and fills the rest with grey. Bytes too many between two
// segments are the one kind that does no harm: some cameras write them.
bool tells_of_damage(std::string_view log) {
  if (log.find("extraneous bytes") != std::string_view::npos) return false;
  return log.find("Corrupt JPEG") != std::string_view::npos ||
         log.find("Premature end") != std::string_view::npos ||
         log.find("libpng error") != std::string_view::npos;
}

struct Reading {
  PixelFormat format;
  int flags;
};

Reading reading_for(SensorKind sensor) {
  switch (sensor) {
    case SensorKind::grey:
      return {PixelFormat::grey8, cv::IMREAD_GRAYSCALE};
    case SensorKind::range:
      return {PixelFormat::depth16, cv::IMREAD_UNCHANGED};
    case SensorKind::surface:
      return {PixelFormat::label16, cv::IMREAD_UNCHANGED};
    case SensorKind::colour:
      break;
  }
  return {PixelFormat::bgr8, cv::IMREAD_COLOR};
}

bool is_frame_of(const cv::Mat& picture, SensorKind sensor) {
  return reading_for(sensor).flags != cv::IMREAD_UNCHANGED || picture.type() == CV_16UC1;
}

std::optional<std::string> decode(const std::vector<std::byte>& bytes, SensorKind sensor,
                                  cv::Mat& picture) {
  constexpr const char* kUnreadable =
      "not a picture that can be read; give a PNG, JPEG, BMP, TIFF, WebP or PNM file or a video";
  std::string log;
  std::optional<std::string> fault;
  try {
    StderrCapture capture;
    const cv::Mat encoded(1, static_cast<int>(bytes.size()), CV_8UC1,
                          const_cast<std::byte*>(bytes.data()));
    picture = cv::imdecode(encoded, reading_for(sensor).flags);
    if (!picture.empty() && is_frame_of(picture, sensor))
      fault = blacken_transparent(bytes, picture);
    log = capture.finish();
  } catch (const std::exception&) {
    return kUnreadable;
  }
  const std::string_view first_line = std::string_view(log).substr(0, log.find('\n'));
  if (tells_of_damage(log)) return fmt::format("damaged ({}); copy or record it again", first_line);
  if (picture.empty()) return kUnreadable;
  if (!is_frame_of(picture, sensor))
    return fmt::format(
        "not a {} frame, which has one channel of 16 bits; give a frame of that "
        "sensor, or an index of this one's",
        name_of(sensor));
  if (fault) return fault;
  return size_fault(picture.cols, picture.rows);
}

}  // namespace

bool read_picture(const fs::path& file, SensorKind sensor, CapturedFrame& frame) {
  std::vector<std::byte> bytes;
  cv::Mat picture;
  std::optional<std::string> fault = read_bytes(file, bytes);
  if (!fault) fault = picture_fault(bytes);
  const bool wants_colours = sensor == SensorKind::colour || sensor == SensorKind::grey;
  if (!fault && wants_colours && is_deep_grey_png(bytes))
    fault = fmt::format(
        "one channel of 16 bits, a range or surface frame and not a {} one; give a "
        "frame of that sensor, or an index of this one's",
        name_of(sensor));
  if (!fault) fault = decode(bytes, sensor, picture);
  if (fault) {
    frame.error = file.native() + ": " + *fault;
    return false;
  }
  copy_picture(picture, reading_for(sensor).format, frame);
  return true;
}

}  // namespace aspect
