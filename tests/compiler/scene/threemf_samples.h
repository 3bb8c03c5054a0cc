// Small 3MF archives.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace aspect {

struct ZipMember {
  std::string name, bytes;
};
std::string zip_of(const std::vector<ZipMember>& members);

// Resources begun: <basematerials> 1, "sky" #1180FF and "slate" #203040FF; <m:colorgroup> 2 of red,
// green and blue.
extern const std::string kThreeMfColours;

// An object with the corners 0 0 0, 1 0 0, 0 2 0 and 0 0 3, turned outwards.
std::string tetrahedron(int id, const std::string& attributes,
                        const std::array<std::string, 4>& triangles);

std::string model_text(const std::string& content, const std::string& attributes = "");
std::vector<ZipMember> threemf_of(const std::string& content, const std::string& attributes = "");

}  // namespace aspect
