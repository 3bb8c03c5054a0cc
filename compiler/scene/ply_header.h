// What a PLY file says it holds.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/scene/mesh_text.h"

namespace aspect {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool list = false;
  PlyType count_type = PlyType::uint8;  // of a list
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  // properties.size() where there is none of these names.
  std::size_t find(std::initializer_list<std::string_view> names) const;
};

// `comment TextureFile NAME`.
struct PlyTexture {
  std::string name;
  std::size_t line = 0;
};

struct PlyHeader {
  enum class Format { text, little_endian, big_endian } format = Format::text;
  std::vector<PlyElement> elements;
  std::vector<PlyTexture> textures;  // texnumber counts them from 0
};

std::size_t bytes_of(PlyType type);

// The largest number of a channel of this type: 255, 65535; 1 of floating-point numbers.
double full_scale(PlyType type);

// Leaves `text` behind end_header. Throws MeshError.
PlyHeader read_ply_header(MeshText& text);

}  // namespace aspect
