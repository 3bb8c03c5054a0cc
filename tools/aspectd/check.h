// aspectd --check: is everything there that a configuration names?
#pragma once

#include <filesystem>

namespace aspect {

// Prints what will be used, in words or as one JSON object, and on standard error what is wrong.
// True where nothing is; settings that the camera refuses are warnings.
bool check(const std::filesystem::path& file, bool json);

}  // namespace aspect
