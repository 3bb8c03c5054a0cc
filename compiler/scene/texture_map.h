// Pictures for textures.
#pragma once

#include <cstddef>
#include <string_view>

#include "compiler/scene/texture.h"
#include "runtime/base/result.h"

namespace aspect {

// Reads the bytes of a PNG file of at most `max_pixels` pixels; an alpha channel is left out. The
// stored values are taken as they are, whatever gamma the file names.
Result<TextureMap> decode_png(std::string_view bytes, std::size_t max_pixels);

// Of the size and the pixels: what stands for the picture in Scene::source.
std::uint64_t digest_of(const TextureMap& map);

}  // namespace aspect
