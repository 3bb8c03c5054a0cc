// Files that are never seen half-written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "compiler/store/done.h"
#include "runtime/base/result.h"

namespace aspect {

// Writes beside the file, flushes to the disk, then renames over it.
Result<Done> write_whole_file(const std::filesystem::path& file,
                              std::span<const std::uint8_t> bytes);

}  // namespace aspect
