// aspectc inspect FILE.store: what a store belongs to and how much it holds.
#pragma once

#include <filesystem>

namespace aspect {

// Exit code.
int run_inspect_store(const std::filesystem::path& file, bool as_json);

}  // namespace aspect
