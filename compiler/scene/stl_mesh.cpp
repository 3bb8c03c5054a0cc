#include "compiler/scene/stl_mesh.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>

namespace aspect {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kHeader = 80, kFirstFace = 84, kFaceBytes = 50;

std::uint32_t byte_at(std::string_view file, std::size_t k) {
  return static_cast<std::uint8_t>(file[k]);
}
std::uint32_t word_at(std::string_view file, std::size_t k) {
  return byte_at(file, k) | byte_at(file, k + 1) << 8 | byte_at(file, k + 2) << 16 |
         byte_at(file, k + 3) << 24;
}
Vector3d vector_at(std::string_view file, std::size_t k) {
  const auto number = [&](std::size_t at) {
    return static_cast<double>(std::bit_cast<float>(word_at(file, at)));
  };
  return {number(k), number(k + 4), number(k + 8)};
}

struct FaceColours {
  bool magics = false;
  Vector3d common = kUncoloured;
  std::size_t uncoloured = 0;  // of those asked for

  Vector3d of(std::uint32_t attribute) {
    const Vector3d low_to_high(attribute & 31u, attribute >> 5 & 31u, attribute >> 10 & 31u);
    const bool own = (attribute >> 15 != 0) != magics;
    if (!own && !magics) ++uncoloured;
    if (!own) return common;
    return (magics ? low_to_high : Vector3d(low_to_high.reverse())) / 31;
  }
};

FaceColours colours_of(std::string_view file) {
  FaceColours colours;
  const std::size_t key = file.substr(0, kHeader - 4).find("COLOR=");
  if (key == std::string_view::npos) return colours;
  const std::size_t at = key + 6;
  colours.magics = true;
  colours.common =
      Vector3d(byte_at(file, at), byte_at(file, at + 1), byte_at(file, at + 2)) / 255.0;
  return colours;
}

}  // namespace

std::optional<ColouredMesh> parse_binary_stl(std::string_view file) {
  const bool text_like = file.starts_with("solid");
  if (file.size() < kFirstFace) {
    if (text_like) return std::nullopt;
    throw MeshError("too short for an STL file; export it again");
  }
  const std::size_t count = word_at(file, kHeader), there = (file.size() - kFirstFace) / kFaceBytes;
  if (text_like && count != there) return std::nullopt;
  if (count > there)
    throw MeshError(fmt::format("says {} faces, but holds {}; export it again", count, there));

  ColouredMesh mesh;
  mesh.parts.push_back({});
  FaceColours colours = colours_of(file);
  for (std::size_t face = 0; face < count; ++face) {
    const std::size_t at = kFirstFace + face * kFaceBytes;
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = add_vertex(mesh, vector_at(file, at + 12 * (k + 1)));
    add_face(mesh, corners, colours.of(byte_at(file, at + 48) | byte_at(file, at + 49) << 8), 0);
  }
  warn_of_uncoloured(mesh, colours.uncoloured, count);
  return mesh;
}

}  // namespace aspect
