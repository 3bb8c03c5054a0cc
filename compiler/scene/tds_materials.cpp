#include "compiler/scene/tds_materials.h"

#include <algorithm>
#include <cstdint>
#include <set>

namespace aspect {
namespace {

enum : std::uint32_t {
  kMain = 0x4D4D,
  kEditor = 0x3D3D,
  kMaterial = 0xAFFF,
  kMaterialName = 0xA000,
  kObject = 0x4000,
  kTriangles = 0x4100,
  kFaces = 0x4120,
  kFaceMaterial = 0x4130,
};
constexpr std::size_t kHeader = 6;

std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t number = 0;
  for (std::size_t k = 0; k < count; ++k)
    number |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + k])} << 8 * k;
  return number;
}

std::string name_in(std::string_view bytes) {
  return std::string(bytes.substr(0, bytes.find('\0')));
}

struct Names {
  std::vector<std::string> used;
  std::set<std::string> defined;
};

// Where the chunks inside one begin; its end where it has none.
std::size_t first_inside(std::uint32_t id, std::string_view content) {
  if (id == kMain || id == kEditor || id == kMaterial || id == kTriangles) return 0;
  if (id == kObject) return std::min(name_in(content).size() + 1, content.size());
  if (id == kFaces && content.size() >= 2)
    return std::min<std::size_t>(2 + 8 * number_at(content, 0, 2), content.size());
  return content.size();
}

void collect(std::string_view bytes, Names& names, int level = 0) {
  constexpr int kMostLevels = 8;  // five are needed
  if (level == kMostLevels) return;
  while (bytes.size() >= kHeader) {
    const std::uint32_t id = number_at(bytes, 0, 2);
    const std::size_t length = number_at(bytes, 2, 4);
    if (length < kHeader || length > bytes.size()) return;
    const std::string_view content = bytes.substr(kHeader, length - kHeader);
    if (id == kMaterialName) names.defined.insert(name_in(content));
    if (id == kFaceMaterial) names.used.push_back(name_in(content));
    collect(content.substr(first_inside(id, content)), names, level + 1);
    bytes.remove_prefix(length);
  }
}

}  // namespace

std::vector<std::string> undefined_tds_materials(std::string_view bytes) {
  Names names;
  collect(bytes, names);
  std::vector<std::string> undefined;
  std::set<std::string> told;
  for (const std::string& name : names.used)
    if (!names.defined.contains(name) && told.insert(name).second) undefined.push_back(name);
  return undefined;
}

}  // namespace aspect
