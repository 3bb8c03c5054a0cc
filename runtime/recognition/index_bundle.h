// Index files of one object or of several: NAME.aspect holds a class index (ASPX) or a bundle of
// them (ASPB, schema/index_bundle.fbs).
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "runtime/recognition/class_index.h"

namespace aspect {

inline constexpr std::size_t kMaxBundledIndexes = 64;

// At least one, in the order of the file. Each is checked as load_index does; a bundle is accepted
// only as a whole. Errors name the file and, in a bundle, the index, from 1.
Result<std::vector<ClassIndex>> load_index_file(const std::filesystem::path& file);
Result<std::vector<ClassIndex>> parse_index_file(std::span<const std::byte> bytes,
                                                 const std::string& name);

}  // namespace aspect
