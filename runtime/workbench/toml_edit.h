// Single values of a TOML file changed in its text, so that all else stays as its author wrote it:
// comments, order, blanks.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "runtime/base/result.h"

namespace aspect {

struct TomlEdit {
  std::string table;                 // "segmentation", "camera.controls"
  std::string key;                   // a bare one: letters, digits, _ and -
  std::optional<std::string> value;  // as TOML has it; none: the key is taken out
  bool first = false;                // a new key comes before the others of its table, not after
};

// A table that is missing is added at the end. What comes out is read again and compared with what
// was to come out: where a file is written so that this cannot be done, that is the error, and it
// names the lines to write by hand.
[[nodiscard]] Result<std::string> edited_toml(std::string text, const std::string& name,
                                              std::span<const TomlEdit> edits);

}  // namespace aspect
