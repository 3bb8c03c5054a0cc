// A file that grows line by line and is there all at once.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/base/result.h"

namespace aspect {

// Written without a name or, where the file system knows no such files, beside its place; finish()
// gives it its name, in place of what had it. Without finish() nothing is left of it.
class StreamedFile {
 public:
  static Result<StreamedFile> create(const std::filesystem::path& file);
  StreamedFile(StreamedFile&& other) noexcept;
  StreamedFile& operator=(StreamedFile&&) = delete;
  ~StreamedFile();

  // The first error is the last thing that happens to it.
  [[nodiscard]] std::optional<Error> write(std::string_view text);
  [[nodiscard]] std::optional<Error> finish();

 private:
  StreamedFile(std::filesystem::path file, int descriptor, bool has_name);
  std::string aside() const;
  Error failed(int reason);

  std::filesystem::path file_;
  int descriptor_ = -1;
  bool has_name_ = false;  // beside its place
};

}  // namespace aspect
