// A file of lines that is never longer than asked for: NAME, then NAME.1, NAME.2, the older the
// higher.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/output/descriptor.h"
#include "runtime/output/output_settings.h"

namespace aspect {

class RotatedFile {
 public:
  // Goes on with a file that is there. A last line without an end, as a power cut leaves it, is
  // ended first.
  [[nodiscard]] static Result<RotatedFile> open(const FileOutput& settings);

  // Whole or not at all. The error says what is the matter; it may be tried again.
  [[nodiscard]] std::optional<Error> append(std::string_view line);

 private:
  explicit RotatedFile(const FileOutput& settings);
  const std::string& path() const { return names_.front(); }
  std::optional<Error> reopen();
  std::optional<Error> rotate();
  std::optional<Error> write(std::string_view text);
  Error failure(const std::string& what) const;

  std::vector<std::string> names_;  // by age; made at the start, so that rotation takes no memory
  std::uint64_t max_bytes_;
  Descriptor file_;
  std::uint64_t size_ = 0;
  bool torn_ = false;  // ends in a piece of a line
};

}  // namespace aspect
