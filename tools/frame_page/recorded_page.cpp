#include "tools/frame_page/recorded_page.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "runtime/capture/recorded_frames.h"
#include "tools/frame_page/frame_page.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

// A line may be as long as a file: no more of it is read than one can have.
class BoundedLines {
 public:
  explicit BoundedLines(const fs::path& file) : stream_(file, std::ios::binary) {}

  // False: there are no more. A line that is too long has one byte more than it may.
  bool next(std::string& line) {
    line.clear();
    std::streambuf& bytes = *stream_.rdbuf();
    for (;;) {
      const int byte = stream_ ? bytes.sbumpc() : EOF;
      if (byte == EOF) return !line.empty();
      if (byte == '\n') return true;
      line += static_cast<char>(byte);
      if (line.size() > kMostLineBytes) return true;
    }
  }

 private:
  std::ifstream stream_;
};

// The pictures behind the names of frames; those of a video one after the other.
class FrameFinder {
 public:
  FrameFinder(fs::path folder, SensorKind sensor) : folder_(std::move(folder)), sensor_(sensor) {}

  // Null: `note` says why.
  const CapturedFrame* find(const PageLine& line, std::string& note) {
    note.clear();
    if (!find_file(line.frame)) {
      note = "the picture is no longer there";
      return nullptr;
    }
    if (!read(note)) return nullptr;
    if (frame_.width_px == line.width_px && frame_.height_px == line.height_px) return &frame_;
    note = fmt::format("another picture is there now, of {} x {} px", frame_.width_px,
                       frame_.height_px);
    return nullptr;
  }

 private:
  // As it is named, or from the folder of the lines; NAME#7 is a frame of a file of several.
  bool find_file(const std::string& name) {
    const std::size_t hash = name.rfind('#');
    const bool is_numbered =
        hash != std::string::npos && hash + 1 < name.size() &&
        std::all_of(name.begin() + static_cast<std::ptrdiff_t>(hash) + 1, name.end(),
                    [](unsigned char c) { return std::isdigit(c) != 0; });
    for (const fs::path& base : {fs::path(), folder_}) {
      std::error_code unknown;
      if (const fs::path whole = base / name; fs::is_regular_file(whole, unknown)) {
        file_ = whole;
        number_.clear();
        return true;
      }
      if (!is_numbered) continue;
      if (const fs::path whole = base / name.substr(0, hash); fs::is_regular_file(whole, unknown)) {
        file_ = whole;
        number_ = name.substr(hash);
        return true;
      }
    }
    return false;
  }

  bool read(std::string& note) {
    const std::string wanted = file_.native() + number_;
    if (number_.empty() || file_ != open_file_ || !source_) open();
    for (int opened = 0; opened < 2; ++opened) {
      for (;;) {
        const FrameStatus status = source_->next(frame_);
        if (status == FrameStatus::end) break;
        if (!number_.empty() && frame_.name != wanted) continue;
        if (status == FrameStatus::frame) return true;
        note = frame_.error;
        return false;
      }
      if (number_.empty()) break;
      open();  // lines need not be in the order of the frames
    }
    note = "the frame is no longer there";
    return false;
  }

  void open() {
    const std::array<fs::path, 1> paths = {file_};
    source_ = std::make_unique<RecordedFrames>(paths, sensor_);
    open_file_ = file_;
  }

  fs::path folder_, file_, open_file_;
  std::string number_;  // with its #
  SensorKind sensor_;
  std::unique_ptr<RecordedFrames> source_;
  CapturedFrame frame_;
};

std::vector<CameraModel> cameras_of(const RecordedPage& recorded, const PageLine& line) {
  std::vector<CameraModel> cameras;
  for (const ClassIndex& index : recorded.indexes)
    cameras.push_back(camera_for(recorded.camera, index, line.width_px, line.height_px));
  return cameras;
}

std::optional<Error> check_lines(const fs::path& file) {
  std::error_code unknown;
  if (!fs::exists(file, unknown)) return Error{file.native() + ": no such file; check the path"};
  if (fs::is_directory(file, unknown))
    return Error{file.native() + ": a folder; a file with lines of aspect-replay was expected"};
  if (!std::ifstream(file)) return Error{file.native() + ": cannot be read; check its permissions"};
  return std::nullopt;
}

std::optional<Error> add_lines(RecordedPage& recorded, FramePage& page,
                               RecordedPageCounts& counts) {
  const SensorKind sensor =
      recorded.indexes.empty() ? SensorKind::colour : recorded.indexes.front().vision.sensor;
  FrameFinder finder(recorded.lines.parent_path(), sensor);
  BoundedLines lines(recorded.lines);
  std::string text;
  for (int number = 1; lines.next(text); ++number) {
    if (text.empty() || text == "\r") continue;
    auto line = read_page_line(text, fmt::format("{}:{}", recorded.lines.native(), number));
    if (!line) return Error{line.error()};
    if (recorded.progress) recorded.progress(counts.frames + 1, line.value().frame);
    PagePicture picture;
    const CapturedFrame* found = finder.find(line.value(), picture.note);
    const std::vector<CameraModel> cameras = cameras_of(recorded, line.value());
    const Frame view = found == nullptr ? Frame() : found->view();
    picture.frame = found == nullptr ? nullptr : &view;
    picture.cameras = cameras;
    ++counts.frames;
    counts.without_picture += found == nullptr ? 1U : 0U;
    if (auto error = page.add(std::move(line).value(), picture)) return error;
  }
  if (counts.frames == 0)
    return Error{recorded.lines.native() + ": holds no lines; give what aspect-replay wrote"};
  return std::nullopt;
}

}  // namespace

Result<RecordedPageCounts> write_recorded_page(RecordedPage recorded) {
  if (auto error = check_lines(recorded.lines)) return *error;
  auto page = FramePage::create(recorded.page, {recorded.lines.filename().native(),
                                                recorded.indexes, std::move(recorded.truth)});
  if (!page) return Error{page.error()};
  RecordedPageCounts counts;
  if (auto error = add_lines(recorded, page.value(), counts)) return *error;
  if (auto error = page.value().finish()) return *error;
  return counts;
}

}  // namespace aspect
