// A file that is read from its beginning, without the C++ library's streams: their locales alone
// would make a static program twice as large.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace aspect {

class InputFile {
 public:
  explicit InputFile(const std::filesystem::path& file);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  // None where it could not be opened, or is no plain file; reason() then says why.
  std::optional<std::uint64_t> size() const;
  std::string reason() const;
  bool is_missing() const;
  // The next bytes; false where there are not as many.
  [[nodiscard]] bool read(std::span<std::byte> bytes);
  [[nodiscard]] bool read(std::span<std::uint8_t> bytes) {
    return read(std::as_writable_bytes(bytes));
  }

 private:
  int descriptor_ = -1, error_ = 0;
};

}  // namespace aspect
