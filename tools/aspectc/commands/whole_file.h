// Files that are never seen half-written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include "compiler/store/done.h"
#include "runtime/base/result.h"

namespace aspect {

// Writes beside the file, flushes to the disk, then renames over it.
Result<Done> write_whole_file(const std::filesystem::path& file,
                              std::span<const std::uint8_t> bytes);
Result<Done> write_whole_text(const std::filesystem::path& file, std::string_view text);

// Whether write_whole_file would find a folder that it may write to, before hours of work.
Result<Done> check_writable(const std::filesystem::path& file);

}  // namespace aspect
