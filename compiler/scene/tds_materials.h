// The materials of 3DS files, of which Assimp drops the names that it does not find.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace aspect {

// The names that faces have and that no material does, in the order of the file, each once. Broken
// chunks end the search. Format: Autodesk's 3D Studio File Toolkit.
std::vector<std::string> undefined_tds_materials(std::string_view bytes);

}  // namespace aspect
