// What a file holds, as a number that tells contents apart: XXH3, 128 bits (Y. Collet, xxHash).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace aspect {

// 32 hexadecimal digits.
std::string content_hash(std::string_view bytes);

inline constexpr const char* kAbsent = "absent";

// The same of a regular file, in memory that does not grow with it; "unreadable" where it cannot be
// read. Where there is none, kAbsent and, if the folder has names that differ from it in case
// alone, a hash of these: readers may take one of them for it.
std::string content_hash_of_file(const std::filesystem::path& file);

}  // namespace aspect
