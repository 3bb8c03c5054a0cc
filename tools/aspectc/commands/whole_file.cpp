#include "tools/aspectc/commands/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "runtime/base/write_all.h"

namespace aspect {
namespace {

Error not_written(const std::filesystem::path& file, int reason) {
  return {fmt::format("{}: cannot be written ({}); check the folder and the space left",
                      file.string(), std::strerror(reason))};
}

// So that the new name outlives a power cut. Some file systems cannot; nothing is lost with them.
void flush_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

}  // namespace

Result<Done> check_writable(const std::filesystem::path& file) {
  std::error_code unknown;
  if (std::filesystem::is_directory(file, unknown)) return not_written(file, EISDIR);
  if (std::filesystem::exists(file, unknown) && !std::filesystem::is_regular_file(file, unknown))
    return Error{file.string() + ": not a regular file, and would be replaced; name another"};
  const std::filesystem::path folder = folder_of(file);
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
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const bool written = write_all(descriptor, text) && ::fsync(descriptor) == 0;
  const int reason = errno;
  ::close(descriptor);
  if (!written) return failed(reason);
  if (::rename(aside.c_str(), file.c_str()) != 0) return failed(errno);
  flush_folder(folder_of(file));
  return Done{};
}

Result<Done> write_whole_text(const std::filesystem::path& file, std::string_view text) {
  return write_whole_file(file, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace aspect
