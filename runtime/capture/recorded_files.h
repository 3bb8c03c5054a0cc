// Which files hold recorded frames, by their names.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "runtime/base/result.h"

namespace aspect {

enum class RecordedKind : std::uint8_t { picture, raw, video };

// A name that ends like nothing known is taken for a picture's.
RecordedKind recorded_kind(const std::filesystem::path& file);

// The files of a folder that end like a picture or raw frames, in the order of their names (byte by
// byte); not those of its subfolders. Nothing is opened. An error names the folder: it cannot be
// listed, or holds none.
Result<std::vector<std::filesystem::path>> frame_files_in(const std::filesystem::path& folder);

}  // namespace aspect
