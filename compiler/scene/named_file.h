// Files that another file names, perhaps in the manner of another system.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aspect {

struct NamedFile {
  std::filesystem::path path;
  bool guessed = false;  // by its last part, or in spite of its case
};

// The regular file that `name` means, written in a file of `folder`: as it stands, with backslashes
// for slashes, then the same of its last part alone; each time also where case alone differs,
// unless several files fit. Nothing where there is none. Each path that is looked at is added to
// `asked`, as is the one that is found.
std::optional<NamedFile> find_named_file(const std::filesystem::path& folder, std::string_view name,
                                         std::vector<std::string>& asked);

}  // namespace aspect
