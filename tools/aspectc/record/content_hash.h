// What a file holds, as a number that tells contents apart: XXH3, 128 bits (Y. Collet, xxHash).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace aspect {

// 32 hexadecimal digits.
std::string content_hash(std::string_view bytes);

inline constexpr const char* kAbsent = "absent";

// The same of a regular file, in memory that does not grow with it; kAbsent where there is none,
// "unreadable" where it cannot be read.
std::string content_hash_of_file(const std::filesystem::path& file);

}  // namespace aspect
