// The pairs of code and value that a DXF file is made of.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/scene/mesh_text.h"

namespace aspect {

struct DxfGroup {
  int code = 0;
  std::string_view value;
};

// What stands between one group 0 and the next: an entity, a layer, a vertex, or a mark such as
// SECTION. Views the file's text.
struct DxfRecord {
  std::string_view kind;  // of group 0
  std::size_t line = 0;
  std::vector<DxfGroup> groups;

  std::string_view text(int code) const;  // the first of that code, or empty
  double number(int code, double otherwise) const;
  double number_in(const DxfGroup& group) const;  // one of `groups`
  int whole(int code, int otherwise) const;
  // Groups code, code + 10 and code + 20.
  Eigen::Vector3d point(int code) const;
};

// All records of a file, up to EOF. Throws MeshError.
std::vector<DxfRecord> read_dxf_records(std::string_view file);

}  // namespace aspect
