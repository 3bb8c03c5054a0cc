#include "runtime/capture/recorded_frames.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <system_error>

#include "runtime/capture/decoders.h"
#include "runtime/capture/raw_frames.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 13> kPictureEndings = {
    ".png",  ".jpg", ".jpeg", ".jpe", ".bmp", ".tif", ".tiff",
    ".webp", ".ppm", ".pgm",  ".pbm", ".pnm", ".jp2"};
constexpr std::array<std::string_view, 14> kVideoEndings = {
    ".avi",  ".mp4", ".m4v", ".mkv", ".mov",  ".webm",  ".mpg",
    ".mpeg", ".ogv", ".wmv", ".flv", ".mjpg", ".mjpeg", ".ts"};

bool ends_like(const fs::path& path, std::span<const std::string_view> endings) {
  std::string ending = path.extension().native();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

// A picture may have its size in its name, too.
bool is_raw(const fs::path& path) {
  return is_raw_name(path) && !ends_like(path, kPictureEndings) && !ends_like(path, kVideoEndings);
}

}  // namespace

RecordedFrames::RecordedFrames(std::span<const fs::path> paths, SensorKind sensor)
    : sensor_(sensor) {
  silence_decoders();
  for (const fs::path& path : paths) add(path);
}

RecordedFrames::~RecordedFrames() = default;

void RecordedFrames::add(const fs::path& path) {
  const auto refuse = [&](const std::string& what) {
    items_.push_back({Kind::unusable, path, path.native() + ": " + what});
  };
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (status.type() == fs::file_type::not_found) return refuse("no such file; check the path");
  if (status.type() == fs::file_type::none)
    return refuse("cannot be looked at: " + code.message() + "; check the path");
  if (fs::is_directory(status)) return add_folder(path);
  if (!fs::is_regular_file(status))
    return refuse("neither a file nor a folder; give a picture, a folder of pictures or a video");
  if (is_raw(path)) {
    items_.push_back({Kind::raw, path, {}, raw_frame_count(path)});
    return;
  }
  const bool is_video = ends_like(path, kVideoEndings);
  if (is_video && sensor_ != SensorKind::colour)
    return refuse(
        "a video, whose frames are in colour, and the index is of another sensor; give "
        "its frames as pictures");
  items_.push_back({is_video ? Kind::video : Kind::picture, path, {}});
}

void RecordedFrames::add_folder(const fs::path& folder) {
  std::vector<fs::path> pictures;
  std::error_code code;
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end;
       entry.increment(code)) {
    std::error_code unknown;
    if (entry->is_regular_file(unknown) &&
        (ends_like(entry->path(), kPictureEndings) || is_raw(entry->path())))
      pictures.push_back(entry->path());
  }
  const std::string name = folder.native() + ": ";
  if (code) {
    items_.push_back({Kind::unusable, folder,
                      name + "cannot be listed: " + code.message() + "; check its permissions"});
    return;
  }
  if (pictures.empty()) {
    const bool has_frames = fs::is_directory(folder / "frames", code);
    items_.push_back({Kind::unusable, folder,
                      name + (has_frames ? "holds no pictures, but a folder frames; give " +
                                               (folder / "frames").native()
                                         : "holds no pictures (.png, .jpg, .bmp and the like); "
                                           "check the path")});
    return;
  }
  std::sort(pictures.begin(), pictures.end(),
            [](const fs::path& a, const fs::path& b) { return a.native() < b.native(); });
  for (const fs::path& picture : pictures) {
    if (is_raw(picture))
      items_.push_back({Kind::raw, picture, {}, raw_frame_count(picture)});
    else
      items_.push_back({Kind::picture, picture, {}});
  }
}

std::optional<std::size_t> RecordedFrames::count() const {
  std::size_t frames = 0;
  for (const Item& item : items_) {
    if (item.kind == Kind::video) return std::nullopt;
    frames += item.frames;
  }
  return frames;
}

FrameStatus RecordedFrames::next(CapturedFrame& frame) {
  FrameStatus status = FrameStatus::end;
  while (status == FrameStatus::end) {
    if (open_ != nullptr) {
      status = next_of_open(frame);
    } else {
      if (next_item_ == items_.size()) return FrameStatus::end;
      status = open_item(items_[next_item_++], frame);
    }
  }
  frame.sequence = sequence_++;
  if (status == FrameStatus::frame) frame.error.clear();
  return status;
}

FrameStatus RecordedFrames::next_of_open(CapturedFrame& frame) {
  const FrameStatus status = open_->next(frame);
  if (status == FrameStatus::end) open_.reset();
  return status;
}

// The end means: look again.
FrameStatus RecordedFrames::open_item(const Item& item, CapturedFrame& frame) {
  frame.name = item.path.native();
  if (item.kind == Kind::picture)
    return read_picture(item.path, sensor_, frame) ? FrameStatus::frame : FrameStatus::failed;
  if (item.kind == Kind::video || item.kind == Kind::raw) {
    open_ = item.kind == Kind::video ? open_video(item.path)
                                     : std::make_unique<RawFrames>(item.path, sensor_);
    return FrameStatus::end;
  }
  frame.error = item.error;
  return FrameStatus::failed;
}

}  // namespace aspect
