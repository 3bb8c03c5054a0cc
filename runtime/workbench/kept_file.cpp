#include "runtime/workbench/kept_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <optional>

#include "runtime/base/write_all.h"
#include "runtime/output/descriptor.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

Error not_written(const fs::path& file) {
  return {
      fmt::format("{}: cannot be written ({}); check the rights of its folder and the room on "
                  "the disk",
                  file.native(), system_error())};
}

fs::path aged(const fs::path& file, int age) {
  return fmt::format("{}.{}", file.native(), age);
}

// Makes room for FILE.1, whatever is missing between.
bool make_older(const fs::path& file) {
  int free = 1;
  while (free < kMostKept && ::access(aged(file, free).c_str(), F_OK) == 0) ++free;
  for (int age = free; age > 1; --age)
    if (std::rename(aged(file, age - 1).c_str(), aged(file, age).c_str()) != 0) return false;
  if (::unlink(aged(file, 1).c_str()) != 0 && errno != ENOENT) return false;
  return true;
}

// So that the new name outlives a power cut; some file systems cannot.
void flush_folder(const fs::path& file) {
  const Descriptor folder(::open(file.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder) ::fsync(folder.get());
}

// The old contents stay reachable under `kept`: by a second name of theirs or, where the file
// system has none, as a copy.
bool keep(const fs::path& file, const fs::path& kept) {
  if (::link(file.c_str(), kept.c_str()) == 0) return true;
  std::error_code code;
  return fs::copy_file(file, kept, fs::copy_options::none, code) && !code;
}

}  // namespace

Result<fs::path> replace_and_keep(const fs::path& name, std::string_view text) {
  std::error_code code;
  const fs::path file = fs::canonical(name, code);
  struct stat status {};
  if (code || ::stat(file.c_str(), &status) != 0) return not_written(name);
  if (!S_ISREG(status.st_mode))
    return Error{name.native() + ": no regular file, and would be replaced; name another"};
  const fs::path aside = fmt::format("{}.{}.part", file.native(), ::getpid());
  std::optional<Error> error;
  {
    const Descriptor written(
        ::open(aside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600));
    if (!written) return not_written(file);
    // The owner may not be ours to give.
    [[maybe_unused]] const int given = ::fchown(written.get(), status.st_uid, status.st_gid);
    if (::fchmod(written.get(), status.st_mode & 07777U) != 0 || !write_all(written.get(), text) ||
        ::fsync(written.get()) != 0)
      error = not_written(file);
  }
  const fs::path kept = aged(file, 1);
  if (!error && (!make_older(file) || !keep(file, kept))) error = not_written(kept);
  if (!error && std::rename(aside.c_str(), file.c_str()) != 0) error = not_written(file);
  if (error) {
    ::unlink(aside.c_str());
    return *error;
  }
  flush_folder(file);
  return kept;
}

}  // namespace aspect
