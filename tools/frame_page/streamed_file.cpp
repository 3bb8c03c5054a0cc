#include "tools/frame_page/streamed_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstring>
#include <utility>

#include "runtime/base/write_all.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kMode = 0644;

Error not_written(const fs::path& file, int reason) {
  return {fmt::format("{}: cannot be written ({}); check the folder and the space left",
                      file.native(), std::strerror(reason))};
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

// So that the name outlives a power cut. Some file systems cannot; nothing is lost with them.
void flush_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

StreamedFile::StreamedFile(fs::path file, int descriptor, bool has_name)
    : file_(std::move(file)), descriptor_(descriptor), has_name_(has_name) {}

StreamedFile::StreamedFile(StreamedFile&& other) noexcept
    : file_(std::move(other.file_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      has_name_(std::exchange(other.has_name_, false)) {}

StreamedFile::~StreamedFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (has_name_) ::unlink(aside().c_str());
}

std::string StreamedFile::aside() const {
  return fmt::format("{}.{}.part", file_.native(), ::getpid());
}

Result<StreamedFile> StreamedFile::create(const fs::path& file) {
  std::error_code unknown;
  if (fs::is_directory(file, unknown)) return not_written(file, EISDIR);
  if (fs::exists(file, unknown) && !fs::is_regular_file(file, unknown))
    return Error{file.native() + ": not a regular file, and would be replaced; name another"};
  const int nameless = ::open(folder_of(file).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kMode);
  if (nameless >= 0) return StreamedFile(file, nameless, false);
  StreamedFile named(file, -1, false);
  named.descriptor_ =
      ::open(named.aside().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kMode);
  if (named.descriptor_ < 0) return not_written(file, errno);
  named.has_name_ = true;
  return named;
}

Error StreamedFile::failed(int reason) {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  if (std::exchange(has_name_, false)) ::unlink(aside().c_str());
  return not_written(file_, reason);
}

std::optional<Error> StreamedFile::write(std::string_view text) {
  if (!write_all(descriptor_, text)) return failed(errno);
  return std::nullopt;
}

std::optional<Error> StreamedFile::finish() {
  if (::fsync(descriptor_) != 0) return failed(errno);
  if (!has_name_) {
    const std::string nameless = fmt::format("/proc/self/fd/{}", descriptor_);
    ::unlink(aside().c_str());  // of a process of that number that was killed here
    if (::linkat(AT_FDCWD, nameless.c_str(), AT_FDCWD, aside().c_str(), AT_SYMLINK_FOLLOW) != 0)
      return failed(errno);
    has_name_ = true;
  }
  if (::rename(aside().c_str(), file_.c_str()) != 0) return failed(errno);
  has_name_ = false;
  ::close(std::exchange(descriptor_, -1));
  flush_folder(folder_of(file_));
  return std::nullopt;
}

}  // namespace aspect
