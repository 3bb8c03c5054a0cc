// The files in a zip archive, which are hostile until they are checked.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace aspect {

// The bytes of a file in an archive; nothing where it has none of that name (which is compared
// without regard to case). Throws MeshError where the archive is broken or the file is larger than
// `max_bytes`, whatever the archive says of its size. Through minizip; O(size).
std::optional<std::string> read_from_zip(std::string_view archive, const std::string& name,
                                         std::size_t max_bytes);

}  // namespace aspect
