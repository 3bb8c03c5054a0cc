// Reader of binary STL files with the colours of their faces: of those that Materialise Magics
// writes Assimp 5.2 reads none (measured).
#pragma once

#include <optional>
#include <string_view>

#include "compiler/scene/coloured_mesh.h"

namespace aspect {

// A face's 16-bit attribute holds 5 bits a channel. VisCAM and SolidView: blue lowest, bit 15 set
// where there is a colour. Materialise Magics, known by COLOR= in the header: red lowest, bit 15
// clear where the face has a colour of its own and not the header's. (en.wikipedia.org, STL (file
// format), "Color in binary STL".) Nothing where the file is text, throws MeshError where it is cut
// off.
std::optional<ColouredMesh> parse_binary_stl(std::string_view file);

}  // namespace aspect
