#include "tools/aspectc/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace aspect {
namespace {

bool write_all(int descriptor, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return ::fsync(descriptor) == 0;
}

Error not_written(const std::filesystem::path& file, int reason) {
  return {fmt::format("{}: cannot be written ({}); check the folder and the space left",
                      file.string(), std::strerror(reason))};
}

}  // namespace

Result<Done> check_writable(const std::filesystem::path& file) {
  std::error_code unknown;
  if (std::filesystem::is_directory(file, unknown)) return not_written(file, EISDIR);
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!std::filesystem::exists(folder, unknown)) return not_written(file, ENOENT);
  if (!std::filesystem::is_directory(folder, unknown)) return not_written(file, ENOTDIR);
  if (::access(folder.c_str(), W_OK | X_OK) != 0) return not_written(file, errno);
  return Done{};
}

Result<Done> write_whole_file(const std::filesystem::path& file,
                              std::span<const std::uint8_t> bytes) {
  const std::string aside = fmt::format("{}.{}.part", file.string(), ::getpid());
  const auto failed = [&](int reason) {
    ::unlink(aside.c_str());
    return not_written(file, reason);
  };
  const int descriptor = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) return failed(errno);
  const bool written = write_all(descriptor, bytes);
  const int reason = errno;
  ::close(descriptor);
  if (!written) return failed(reason);
  if (::rename(aside.c_str(), file.c_str()) != 0) return failed(errno);
  return Done{};
}

}  // namespace aspect
