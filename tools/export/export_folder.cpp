#include "tools/export/export_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "runtime/base/write_all.h"

namespace aspect {
namespace {

Error not_written(const std::filesystem::path& file, int reason) {
  return {fmt::format("{}: cannot be written ({}); check the folder and the space left",
                      file.string(), std::strerror(reason))};
}

constexpr std::string_view kAside = ".aspect-export.";

// -1 where it cannot be opened, or a program that runs has it.
int locked_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
  if (descriptor < 0 || ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  const int reason = errno;
  ::close(descriptor);
  errno = reason;
  return -1;
}

void remove_left_behind(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.path().filename().native().starts_with(kAside)) found.push_back(entry.path());
  for (const std::filesystem::path& aside : found) {
    const int lock = locked_folder(aside);
    if (lock < 0) continue;
    std::filesystem::remove_all(aside, ignored);
    ::close(lock);
  }
}

}  // namespace

Result<ExportFolder> ExportFolder::open(const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  std::error_code unknown;
  if (!std::filesystem::is_directory(folder, unknown))
    return not_written(folder, failure ? failure.value() : ENOTDIR);
  remove_left_behind(folder);
  const std::filesystem::path aside = folder / fmt::format("{}{}", kAside, ::getpid());
  std::filesystem::create_directory(aside, failure);
  if (failure) return not_written(folder, failure.value());
  const int lock = locked_folder(aside);
  if (lock < 0) return not_written(folder, errno);
  return ExportFolder(folder, aside, lock);
}

ExportFolder::ExportFolder(ExportFolder&& other) noexcept
    : folder_(std::move(other.folder_)),
      aside_(std::move(other.aside_)),
      lock_(std::exchange(other.lock_, -1)),
      names_(std::move(other.names_)),
      bytes_(other.bytes_) {}

ExportFolder::~ExportFolder() {
  if (lock_ < 0) return;
  std::error_code ignored;
  std::filesystem::remove_all(aside_, ignored);
  ::close(lock_);
}

Result<Done> ExportFolder::add(const std::string& name, std::string_view text) {
  const int descriptor =
      ::open((aside_ / name).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) return not_written(folder_ / name, errno);
  const bool written = write_all(descriptor, text);
  const int reason = errno;
  // Some file systems tell only here that the disk is full.
  const bool closed = ::close(descriptor) == 0;
  if (!written || !closed) return not_written(folder_ / name, written ? errno : reason);
  names_.push_back(name);
  bytes_ += text.size();
  return Done{};
}

// Thousands of files are flushed together, not one by one.
Result<Done> ExportFolder::commit() {
  if (::syncfs(lock_) != 0) return not_written(folder_, errno);
  for (const std::string& name : names_)
    if (::rename((aside_ / name).c_str(), (folder_ / name).c_str()) != 0)
      return not_written(folder_ / name, errno);
  if (::syncfs(lock_) != 0) return not_written(folder_, errno);
  return Done{};
}

}  // namespace aspect
