#include "tests/tools/aspectc/small_disk.h"

#include <sched.h>
#include <sys/mount.h>

#include <string>
#include <utility>

namespace aspect {
namespace {

std::string size_option(int kib) {
  return "size=" + std::to_string(kib) + "k";
}

bool leave_the_common_namespace() {
  static const bool left =
      unshare(CLONE_NEWNS) == 0 && mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
  return left;
}

}  // namespace

std::optional<SmallDisk> SmallDisk::mount_at(const std::filesystem::path& folder, int kib) {
  std::filesystem::create_directories(folder);
  if (!leave_the_common_namespace() ||
      mount("none", folder.c_str(), "tmpfs", 0, size_option(kib).c_str()) != 0)
    return std::nullopt;
  return SmallDisk(folder);
}

SmallDisk::SmallDisk(SmallDisk&& other) noexcept : folder_(std::exchange(other.folder_, {})) {}

SmallDisk::~SmallDisk() {
  if (!folder_.empty()) umount2(folder_.c_str(), MNT_DETACH);
}

bool SmallDisk::resize(int kib) const {
  return mount("none", folder_.c_str(), "tmpfs", MS_REMOUNT, size_option(kib).c_str()) == 0;
}

bool SmallDisk::make_read_only() const {
  return mount("none", folder_.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr) == 0;
}

}  // namespace aspect
