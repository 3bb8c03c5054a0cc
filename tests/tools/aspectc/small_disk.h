// A disk of a few kilobytes, in the memory and in a mount namespace of this process alone, so that
// it is gone with it. Nothing of that kind without the right to mount.
#pragma once

#include <filesystem>
#include <optional>

namespace aspect {

class SmallDisk {
 public:
  // On an empty folder. Nothing where this process may not mount.
  static std::optional<SmallDisk> mount_at(const std::filesystem::path& folder, int kib);
  SmallDisk(SmallDisk&& other) noexcept;
  SmallDisk& operator=(SmallDisk&&) = delete;
  ~SmallDisk();

  bool resize(int kib) const;
  bool make_read_only() const;

 private:
  explicit SmallDisk(std::filesystem::path folder) : folder_(std::move(folder)) {}
  std::filesystem::path folder_;
};

}  // namespace aspect
