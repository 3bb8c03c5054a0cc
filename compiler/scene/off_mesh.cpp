#include "compiler/scene/off_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "compiler/scene/mesh_text.h"

namespace aspect {
namespace {

using Eigen::Vector3d;
using Words = std::span<const std::string_view>;

struct Header {
  bool colours = false, normals = false;
};

Header read_header(MeshText& text, std::string_view word) {
  Header header;
  const std::string_view whole = word;
  if (word.starts_with("ST")) word.remove_prefix(2);
  if (word.starts_with('C')) header.colours = true, word.remove_prefix(1);
  if (word.starts_with('N')) header.normals = true, word.remove_prefix(1);
  if (word != "OFF")
    text.fail(fmt::format("'{}' where OFF, COFF, NOFF or CNOFF should be; export it as plain OFF",
                          shown(whole)));
  return header;
}

std::optional<Vector3d> colour_of(const MeshText& text, Words words) {
  if (words.size() < 3) return std::nullopt;
  Vector3d colour;
  bool whole = true;
  for (std::size_t k = 0; k < 3; ++k) {
    colour[static_cast<Eigen::Index>(k)] = text.number(words[k]);
    if (words[k].find('.') != std::string_view::npos) whole = false;
  }
  return whole && colour.maxCoeff() > 1 ? colour / 255 : colour;
}

}  // namespace

ColouredMesh parse_off(std::string_view file, const Vector3d& stand_in) {
  MeshText text(file);
  std::vector<std::string_view> words = text.take_words("OFF");
  const Header header = read_header(text, words[0]);
  words.erase(words.begin());
  if (words.size() == 1 && words[0] == "BINARY")
    text.fail("binary OFF is not read; export it as text");
  if (words.empty()) words = text.take_words("the counts");
  if (words.size() < 2) text.fail("no counts of vertices and faces; export it again");
  const std::size_t vertices = text.count(words[0], ColouredMesh::kMaxVertices);
  const std::size_t faces = text.count(words[1], ColouredMesh::kMaxTriangles);

  ColouredMesh mesh;
  mesh.parts.push_back({});
  std::vector<Vector3d> vertex_colours;
  for (std::size_t k = 0; k < vertices; ++k) {
    words = text.take_words("a vertex");
    if (words.size() < 3) text.fail("a vertex of fewer than 3 numbers; export it again");
    add_vertex(mesh, {text.number(words[0]), text.number(words[1]), text.number(words[2])});
    const std::size_t skipped = header.normals ? 6 : 3;
    const Words rest = Words(words).subspan(std::min(skipped, words.size()));
    const auto colour = header.colours ? colour_of(text, rest) : std::nullopt;
    if (header.colours && !colour)
      text.fail("a vertex without the colour that COFF promises; give all of them one");
    vertex_colours.push_back(colour.value_or(kUncoloured));
  }
  std::vector<std::uint32_t> corners;
  std::size_t uncoloured = 0;
  for (std::size_t k = 0; k < faces; ++k) {
    words = text.take_words("a face");
    const std::size_t count = text.count(words[0], ColouredMesh::kMaxFaceCorners);
    if (words.size() < count + 1) text.fail("a face without all its corners; export it again");
    corners.clear();
    Vector3d mean = Vector3d::Zero();
    for (std::size_t c = 1; c <= count; ++c) {
      corners.push_back(static_cast<std::uint32_t>(text.count(words[c], mesh.vertices.size())));
      if (corners.back() >= vertices)
        text.fail(fmt::format("vertex {}, but there are {}", corners.back(), vertices));
      mean += vertex_colours[corners.back()] / static_cast<double>(count);
    }
    const Words rest = Words(words).subspan(count + 1);
    std::optional<Vector3d> colour = colour_of(text, rest);
    if (!colour && !rest.empty()) {
      colour = stand_in;
      if (mesh.missing.empty())
        mesh.missing.push_back({{},
                                text.line(),
                                fmt::format("colour '{}' is a place in a colour map, which OFF "
                                            "files do not hold",
                                            shown(rest[0])),
                                "write r g b",
                                {0}});
    }
    if (!colour && !header.colours) ++uncoloured;
    add_face(mesh, corners, colour.value_or(mean), 0);
  }
  warn_of_uncoloured(mesh, uncoloured, faces);
  return mesh;
}

}  // namespace aspect
