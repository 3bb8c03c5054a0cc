#include "runtime/base/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <system_error>

namespace aspect {

// Without waiting: what turns out to be a pipe must not hold the program up.
InputFile::InputFile(const std::filesystem::path& file)
    : descriptor_(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)),
      error_(descriptor_ < 0 ? errno : 0) {}

InputFile::~InputFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

std::optional<std::uint64_t> InputFile::size() const {
  struct stat status {};
  if (descriptor_ < 0 || fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode))
    return std::nullopt;
  return static_cast<std::uint64_t>(status.st_size);
}

std::string InputFile::reason() const {
  return error_ == 0 ? "not a file" : std::generic_category().message(error_);
}

bool InputFile::is_missing() const {
  return error_ == ENOENT || error_ == ENOTDIR;
}

bool InputFile::read(std::span<std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
    if (count > 0)
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    else if (count == 0 || errno != EINTR)
      return false;
  }
  return true;
}

}  // namespace aspect
