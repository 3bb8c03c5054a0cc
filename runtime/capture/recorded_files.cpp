#include "runtime/capture/recorded_files.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <string_view>
#include <system_error>

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

}  // namespace

RecordedKind recorded_kind(const fs::path& file) {
  // A picture may have its size in its name, too.
  if (ends_like(file, kPictureEndings)) return RecordedKind::picture;
  if (ends_like(file, kVideoEndings)) return RecordedKind::video;
  return is_raw_name(file) ? RecordedKind::raw : RecordedKind::picture;
}

Result<std::vector<fs::path>> frame_files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code code;
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end;
       entry.increment(code)) {
    std::error_code unknown;
    if (entry->is_regular_file(unknown) && (ends_like(entry->path(), kPictureEndings) ||
                                            recorded_kind(entry->path()) == RecordedKind::raw))
      files.push_back(entry->path());
  }
  const std::string name = folder.native() + ": ";
  if (code) return Error{name + "cannot be listed: " + code.message() + "; check its permissions"};
  if (files.empty()) {
    const bool has_frames = fs::is_directory(folder / "frames", code);
    return Error{name + (has_frames ? "holds no pictures, but a folder frames; give " +
                                          (folder / "frames").native()
                                    : "holds no pictures (.png, .jpg, .bmp and the like); "
                                      "check the path")};
  }
  std::sort(files.begin(), files.end(),
            [](const fs::path& a, const fs::path& b) { return a.native() < b.native(); });
  return files;
}

}  // namespace aspect
