#include "runtime/output/rotated_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <optional>

namespace aspect {

RotatedFile::RotatedFile(const FileOutput& settings)
    : names_{settings.path.string()}, max_bytes_(settings.max_bytes) {
  for (int age = 1; age <= settings.keep; ++age)
    names_.push_back(names_.front() + "." + std::to_string(age));
}

Result<RotatedFile> RotatedFile::open(const FileOutput& settings) {
  RotatedFile file(settings);
  if (auto error = file.reopen()) return *error;
  return file;
}

std::optional<Error> RotatedFile::append(std::string_view line) {
  if (!file_)
    if (auto error = reopen()) return error;
  if (torn_) {
    if (auto error = write("\n")) return error;
    torn_ = false;
  }
  if (size_ > 0 && size_ + line.size() > max_bytes_)
    if (auto error = rotate()) return error;
  return write(line);
}

std::optional<Error> RotatedFile::reopen() {
  // Without O_NONBLOCK, somebody's pipe of that name would be waited for.
  file_.reset(::open(path().c_str(),
                     O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC | O_NOCTTY | O_NONBLOCK, 0644));
  if (!file_) return failure("cannot be opened for writing");
  struct stat status {};
  if (::fstat(file_.get(), &status) != 0 || !S_ISREG(status.st_mode)) {
    file_.reset();
    return Error{path() + ": is no plain file; choose another path"};
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
  char last = '\n';
  torn_ = size_ > 0 && ::pread(file_.get(), &last, 1, status.st_size - 1) == 1 && last != '\n';
  return std::nullopt;
}

std::optional<Error> RotatedFile::rotate() {
  for (std::size_t age = names_.size() - 1; age > 0; --age)
    if (std::rename(names_[age - 1].c_str(), names_[age].c_str()) != 0 && errno != ENOENT)
      return failure("cannot be renamed to ." + std::to_string(age));
  if (names_.size() == 1 && ::unlink(path().c_str()) != 0 && errno != ENOENT)
    return failure("cannot be removed");
  file_.reset();
  return reopen();
}

std::optional<Error> RotatedFile::write(std::string_view text) {
  const ssize_t written = ::write(file_.get(), text.data(), text.size());
  if (written == static_cast<ssize_t>(text.size())) {
    size_ += text.size();
    return std::nullopt;
  }
  // A disk that is almost full takes a piece.
  if (written >= 0) errno = ENOSPC;
  const Error error = failure("cannot be written");
  if (written > 0 && ::ftruncate(file_.get(), static_cast<off_t>(size_)) != 0) {
    size_ += static_cast<std::uint64_t>(written);
    torn_ = true;
  }
  return error;
}

Error RotatedFile::failure(const std::string& what) const {
  return Error{path() + ": " + what + ": " + system_error() +
               "; check its folder's permissions and the room on the disk"};
}

}  // namespace aspect
