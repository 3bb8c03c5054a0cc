// A file that is replaced whole, and its former contents, which are kept.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "runtime/base/result.h"

namespace aspect {

inline constexpr int kMostKept = 9;

// `file` holds the text, with the rights that it had; what it held before is FILE.1, and what was
// FILE.1 is FILE.2, up to FILE.9. At every moment, power cuts included, there is a whole file of
// that name. Gives FILE.1. A link is followed.
[[nodiscard]] Result<std::filesystem::path> replace_and_keep(const std::filesystem::path& file,
                                                             std::string_view text);

}  // namespace aspect
