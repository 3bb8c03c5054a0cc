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

}  // namespace

Result<Done> write_whole_file(const std::filesystem::path& file,
                              std::span<const std::uint8_t> bytes) {
  const std::string aside = fmt::format("{}.{}.part", file.string(), ::getpid());
  const auto failed = [&](int reason) {
    ::unlink(aside.c_str());
    return Error{fmt::format("{}: cannot be written ({}); check the folder and the space left",
                             file.string(), std::strerror(reason))};
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
