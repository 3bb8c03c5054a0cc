#include "compiler/scene/texture_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

#include "compiler/scene/coloured_mesh.h"
#include "compiler/scene/mesh_text.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxBytes = std::uintmax_t{256} << 20;

bool is_file(const fs::path& path) {
  std::error_code unknown;
  return fs::is_regular_file(path, unknown);
}

std::string lower(std::string name) {
  for (char& letter : name)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return name;
}

// A file beside the mesh whose name differs in case alone; empty where there is none.
std::string like(const fs::path& folder, const std::string& name) {
  std::string found;
  std::error_code unknown;
  const fs::path searched = folder.empty() ? fs::path(".") : folder;
  for (fs::directory_iterator entry(searched, unknown), end; !unknown && entry != end;
       entry.increment(unknown)) {
    const std::string other = entry->path().filename().string();
    if (lower(other) == lower(name) && (found.empty() || other < found)) found = other;
  }
  return found;
}

}  // namespace

std::vector<std::uint8_t> load_texture(const fs::path& folder, std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  const fs::path last_part = fs::path(name).filename();
  fs::path path = folder / name;
  if (!is_file(path)) path = folder / last_part;
  if (last_part.empty() || !is_file(path)) {
    const std::string other = like(folder, last_part.string());
    if (!other.empty())
      throw MeshError(fmt::format("is not there, but '{}' is; give them one name", shown(other)));
    throw MeshError("is not there; put it beside the mesh");
  }
  std::error_code unknown;
  const std::uintmax_t bytes = fs::file_size(path, unknown);
  if (unknown || bytes > kMaxBytes)
    throw MeshError(fmt::format("is larger than {} MiB; scale it down", kMaxBytes >> 20));
  std::ifstream stream(path, std::ios::binary);
  std::vector<std::uint8_t> read{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad()) throw MeshError("cannot be read; check its permissions");
  return read;
}

}  // namespace aspect
