// Names of layers and blocks in DXF files.
#pragma once

#include <string>
#include <string_view>

namespace aspect {

// The same for names that differ in case alone. Letters of ASCII, and those of Latin-1, Greek and
// Cyrillic in UTF-8, which files are in since AutoCAD 2007.
std::string dxf_key(std::string_view name);

}  // namespace aspect
