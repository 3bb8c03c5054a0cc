// The numbers of a PLY file's elements.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "compiler/scene/mesh_text.h"
#include "compiler/scene/ply_header.h"

namespace aspect {

// What stands behind the header, number after number, whatever the format. Views the file and the
// text, which is at the header's end.
class PlyNumbers {
 public:
  PlyNumbers(std::string_view file, MeshText& text, PlyHeader::Format format)
      : file_(file), text_(text), format_(format), position_(text.position()) {}

  // Throws MeshError where the file ends or the word is no finite number.
  double next(PlyType type) {
    return format_ == PlyHeader::Format::text ? next_word() : next_bytes(type);
  }

 private:
  double next_word();
  double next_bytes(PlyType type);

  std::string_view file_;
  MeshText& text_;
  PlyHeader::Format format_;
  std::size_t position_;
  std::vector<std::string_view> words_;
  std::size_t word_ = 0;
};

}  // namespace aspect
