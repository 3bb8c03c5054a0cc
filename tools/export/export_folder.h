// A folder of many files, which are all written aside before the first one takes its place: in a
// folder within it, .aspect-export.PID, which is locked as long as its program runs. One without a
// lock is what a killed program has left behind, and is removed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/store/done.h"
#include "runtime/base/result.h"

namespace aspect {

class ExportFolder {
 public:
  // Creates the folder where there is none, and finds out whether files can be written there.
  static Result<ExportFolder> open(const std::filesystem::path& folder);

  ExportFolder(ExportFolder&& other) noexcept;
  ExportFolder& operator=(ExportFolder&&) = delete;
  ~ExportFolder();  // what was not committed is gone

  Result<Done> add(const std::string& name, std::string_view text);

  // Each file replaces what had its name; other files stay. Nothing is replaced before all are on
  // the disk.
  Result<Done> commit();

  std::size_t files() const { return names_.size(); }
  std::size_t bytes() const { return bytes_; }

 private:
  ExportFolder(std::filesystem::path folder, std::filesystem::path aside, int lock)
      : folder_(std::move(folder)), aside_(std::move(aside)), lock_(lock) {}

  std::filesystem::path folder_, aside_;
  int lock_ = -1;  // descriptor of the folder aside; none: it is gone
  std::vector<std::string> names_;
  std::size_t bytes_ = 0;
};

}  // namespace aspect
