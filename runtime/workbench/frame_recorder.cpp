#include "runtime/workbench/frame_recorder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>

#include "runtime/base/write_all.h"
#include "runtime/output/descriptor.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = "frame_";
constexpr int kMostNumber = 999'999;

// V4L2's four characters; null of what cameras do not give.
const char* fourcc_of(PixelFormat format) {
  switch (format) {
    case PixelFormat::yuyv8:
      return "YUYV";
    case PixelFormat::uyvy8:
      return "UYVY";
    case PixelFormat::nv12:
      return "NV12";
    case PixelFormat::nv21:
      return "NV21";
    case PixelFormat::bayer_rggb8:
      return "RGGB";
    case PixelFormat::bayer_grbg8:
      return "GRBG";
    case PixelFormat::bayer_gbrg8:
      return "GBRG";
    case PixelFormat::bayer_bggr8:
      return "BA81";
    default:
      return nullptr;
  }
}

std::string pnm_header(char kind, const Frame& frame, int most) {
  return fmt::format("P{}\n{} {}\n{}\n", kind, frame.width_px, frame.height_px, most);
}

// Red first, three bytes a pixel.
std::string ppm_of(const Frame& frame) {
  const bool blue_first = frame.format == PixelFormat::bgr8 || frame.format == PixelFormat::bgrx8;
  const int step = bytes_per_pixel(frame.format);
  std::string text = pnm_header('6', frame, 255);
  for (int y = 0; y < frame.height_px; ++y) {
    const std::uint8_t* at = frame.data + y * frame.stride_bytes;
    for (int x = 0; x < frame.width_px; ++x, at += step)
      for (const int channel : {blue_first ? 2 : 0, 1, blue_first ? 0 : 2})
        text += static_cast<char>(at[channel]);
  }
  return text;
}

// Of 8 bits, or 16 with the higher byte first.
std::string pgm_of(const Frame& frame) {
  const bool wide = bytes_per_pixel(frame.format) == 2;
  std::string text = pnm_header('5', frame, wide ? 65535 : 255);
  for (int y = 0; y < frame.height_px; ++y) {
    const std::uint8_t* at = frame.data + y * frame.stride_bytes;
    for (int x = 0; x < frame.width_px; ++x) {
      std::uint16_t value = at[x];
      if (wide) std::memcpy(&value, at + 2 * x, sizeof value);
      if (wide) text += static_cast<char>(value >> 8U);
      text += static_cast<char>(value & 255U);
    }
  }
  return text;
}

struct FrameFile {
  std::string ending, content;
};

FrameFile file_of(const FrameCopy& copy) {
  const Frame& frame = copy.frame();
  if (const char* fourcc = fourcc_of(frame.format)) {
    const auto bytes = copy.bytes();
    return {fmt::format(".{}x{}.{}", frame.width_px, frame.height_px, fourcc),
            std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size())};
  }
  switch (frame.format) {
    case PixelFormat::grey8:
    case PixelFormat::depth16:
    case PixelFormat::label16:
      return {".pgm", pgm_of(frame)};
    default:
      return {".ppm", ppm_of(frame)};
  }
}

// The largest number of a frame in the folder; 0: there is none.
int last_number(const fs::path& folder, std::error_code& code) {
  int last = 0;
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end;
       entry.increment(code)) {
    const std::string name = entry->path().filename().native();
    if (!name.starts_with(kPrefix)) continue;
    int number = 0;
    const char* const begin = name.data() + kPrefix.size();
    const auto read = std::from_chars(begin, name.data() + name.size(), number);
    if (read.ec == std::errc() && number <= kMostNumber) last = std::max(last, number);
  }
  return last;
}

Error not_written(const fs::path& file) {
  return {fmt::format("{}: cannot be written ({}); check the folder and the space left",
                      file.native(), std::strerror(errno))};
}

// A file that is there already is never touched; what was begun is taken away.
std::optional<Error> write_new(int folder, const fs::path& path, const std::string& name,
                               std::string_view content) {
  const Descriptor file(
      ::openat(folder, name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644));
  if (!file) return not_written(path / name);
  if (!write_all(file.get(), content)) {
    const Error error = not_written(path / name);
    ::unlinkat(folder, name.c_str(), 0);
    return error;
  }
  return std::nullopt;
}

}  // namespace

void FrameRecorder::show(const Frame& frame) noexcept {
  needed_bytes_.store(FrameCopy::bytes_of(frame), std::memory_order_relaxed);
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock.owns_lock() || count_ == copies_.size() || !copies_[count_].copy(frame)) return;
  if (++count_ == copies_.size()) news_.notify_all();
}

// Fills copies_. The first frame only tells how much memory they need.
void FrameRecorder::collect(std::chrono::milliseconds patience) {
  constexpr std::chrono::milliseconds kLook{20};
  const auto deadline = std::chrono::steady_clock::now() + patience;
  wanted_.store(true, std::memory_order_release);
  bool has_room = false;
  for (bool done = false; !done && std::chrono::steady_clock::now() < deadline;) {
    const std::size_t needed = needed_bytes_.load(std::memory_order_relaxed);
    {
      const std::lock_guard lock(mutex_);
      if (needed > 0 && !has_room) {
        copies_.resize(kFrames);
        for (FrameCopy& copy : copies_) copy.make_room(needed);
        has_room = true;
      }
      done = has_room && count_ == copies_.size();
    }
    if (done) break;
    std::unique_lock lock(waiting_);
    news_.wait_for(lock, kLook);
  }
  wanted_.store(false, std::memory_order_release);
}

Result<Recorded> FrameRecorder::record(const fs::path& folder, std::chrono::milliseconds patience) {
  std::error_code code;
  fs::create_directories(folder, code);
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!opened)
    return Error{fmt::format("{}: is no folder that can be written to ({}); name another one",
                             folder.native(), std::strerror(errno))};
  needed_bytes_.store(0, std::memory_order_relaxed);
  collect(patience);
  std::vector<FrameCopy> copies;
  {
    const std::lock_guard lock(mutex_);
    copies.swap(copies_);
    copies.resize(std::exchange(count_, 0));
  }
  if (copies.empty())
    return Error{
        "no frame came, so that none was recorded; is the camera streaming, or are the "
        "frames paused?"};
  int number = last_number(folder, code);
  if (code)
    return Error{fmt::format("{}: cannot be listed ({}); name another folder", folder.native(),
                             code.message())};
  Recorded recorded;
  for (const FrameCopy& copy : copies) {
    if (++number > kMostNumber)
      return Error{folder.native() + ": has a frame 999999 already; name another folder"};
    const FrameFile file = file_of(copy);
    const std::string name = fmt::format("{}{:06}{}", kPrefix, number, file.ending);
    if (auto error = write_new(opened.get(), folder, name, file.content)) return *error;
    if (recorded.frames++ == 0) recorded.first = folder / name;
    recorded.last = folder / name;
  }
  return recorded;
}

}  // namespace aspect
