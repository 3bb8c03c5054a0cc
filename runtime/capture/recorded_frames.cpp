#include "runtime/capture/recorded_frames.h"

#include <system_error>

#include "runtime/capture/decoders.h"
#include "runtime/capture/raw_frames.h"
#include "runtime/capture/recorded_files.h"

namespace aspect {

namespace fs = std::filesystem;

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
  const RecordedKind kind = recorded_kind(path);
  if (kind == RecordedKind::raw) {
    items_.push_back({Kind::raw, path, {}, raw_frame_count(path)});
    return;
  }
  const bool is_video = kind == RecordedKind::video;
  if (is_video && sensor_ != SensorKind::colour)
    return refuse(
        "a video, whose frames are in colour, and the index is of another sensor; give "
        "its frames as pictures");
  items_.push_back({is_video ? Kind::video : Kind::picture, path, {}});
}

void RecordedFrames::add_folder(const fs::path& folder) {
  const Result<std::vector<fs::path>> files = frame_files_in(folder);
  if (!files) {
    items_.push_back({Kind::unusable, folder, files.error()});
    return;
  }
  for (const fs::path& file : files.value()) {
    if (recorded_kind(file) == RecordedKind::raw)
      items_.push_back({Kind::raw, file, {}, raw_frame_count(file)});
    else
      items_.push_back({Kind::picture, file, {}});
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
