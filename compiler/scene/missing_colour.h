// Colours that a file names and that are not there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace aspect {

struct MissingColour {
  std::string file;                       // that names it; empty: the file that is read
  std::size_t line = 0;                   // 0: the format has none
  std::string what;                       // "usemtl 'red' is in no library"
  std::string cure;                       // "define it"
  std::vector<std::uint32_t> parts = {};  // of a mesh, that lack it; empty: all
};

// "FILE:LINE: what"
std::string line_of(const MissingColour& missing);

// What else can be done about it.
inline constexpr std::string_view kOrGoOn =
    ", or go on with --missing-colour R,G,B ([mesh] missing_colour in a project)";

// The one line in which a reader refuses the file.
std::string refusal_of(const MissingColour& missing);

}  // namespace aspect
