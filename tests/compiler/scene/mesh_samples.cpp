#include "tests/compiler/scene/mesh_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "compiler/scene/picture_fit.h"
#include "tests/compiler/scene/scene_samples.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

std::string bytes_of(std::uint64_t value, std::size_t count, bool big = false) {
  std::string bytes;
  for (std::size_t k = 0; k < count; ++k)
    bytes += static_cast<char>(value >> 8 * (big ? count - 1 - k : k) & 255u);
  return bytes;
}
std::string float_bytes(double value, bool big = false) {
  return bytes_of(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4, big);
}
std::string words(const Vector3d& v) {
  return fmt::format("{} {} {}", v.x(), v.y(), v.z());
}
std::string rgb_words(const Vector3d& colour) {
  return words(255 * colour);
}

// Little-endian positions and indices of all faces, two triangles each.
std::string gltf_buffer() {
  std::string buffer;
  for (const CubeFace& face : cube_faces())
    for (const Vector3d& corner : face.corners)
      for (const double x : corner) buffer += float_bytes(x);
  for (const int corner : {0, 1, 2, 0, 2, 3}) buffer += bytes_of(static_cast<unsigned>(corner), 2);
  return buffer;
}

std::string gltf_json(const std::string& uri) {
  std::string primitives, materials, accessors, views;
  for (std::size_t k = 0; k < 6; ++k) {
    const CubeFace& face = cube_faces()[k];
    Vector3d least = face.corners[0], greatest = least;
    for (const Vector3d& corner : face.corners)
      least = least.cwiseMin(corner), greatest = greatest.cwiseMax(corner);
    const auto list = [](const Vector3d& v) { return fmt::format("{},{},{}", v[0], v[1], v[2]); };
    primitives +=
        fmt::format(R"({{"attributes":{{"POSITION":{}}},"indices":6,"material":{}}},)", k, k);
    materials +=
        fmt::format(R"({{"name":"{}","pbrMetallicRoughness":{{"baseColorFactor":[{},1]}}}},)",
                    face.name, list(face.colour));
    accessors += fmt::format(
        R"({{"bufferView":{},"componentType":5126,"count":4,"type":"VEC3","min":[{}],"max":[{}]}},)",
        k, list(least), list(greatest));
    views += fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":48}},)", 48 * k);
  }
  primitives.pop_back(), materials.pop_back();
  return fmt::format(
      R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],)"
      R"("nodes":[{{"mesh":0,"name":"cube"}}],"meshes":[{{"primitives":[{}]}}],)"
      R"("materials":[{}],"accessors":[{}{{"bufferView":6,"componentType":5123,"count":6,)"
      R"("type":"SCALAR"}}],"bufferViews":[{}{{"buffer":0,"byteOffset":288,"byteLength":12}}],)"
      R"("buffers":[{{{}"byteLength":300}}]}})",
      primitives, materials, accessors, views, uri);
}

std::string dxf_point(int code, const Vector3d& p) {
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n", code, p.x(), code + 10, p.y(), code + 20, p.z());
}

}  // namespace

const std::vector<CubeFace>& cube_faces() {
  static const std::vector<CubeFace> faces = [] {
    std::vector<CubeFace> made;
    const std::array<int, 6> aci = {1, 2, 3, 4, 5, 6};
    const std::array<Vector3d, 6> colours = {Vector3d(1, 0, 0), {1, 1, 0}, {0, 1, 0},
                                             {0, 1, 1},         {0, 0, 1}, {1, 0, 1}};
    for (std::size_t k = 0; k < 6; ++k) {
      CubeFace face;
      const auto axis = static_cast<Eigen::Index>(k / 2);
      const double side = k % 2 == 0 ? -10 : 10;
      for (std::size_t c = 0; c < 4; ++c) {
        Vector3d corner;
        corner[axis] = side;
        corner[(axis + 1) % 3] = c == 1 || c == 2 ? 10 : -10;
        corner[(axis + 2) % 3] = c >= 2 ? 10 : -10;
        face.corners[c] = kCubeCentre + corner;
      }
      face.colour = colours[k];
      face.aci = aci[k];
      face.name = fmt::format("side{}", k);
      made.push_back(face);
    }
    return made;
  }();
  return faces;
}

Scene bob_cube() {
  const double scale = 0.9 * fitting_radius(Studio{}) / std::sqrt(300);
  std::string text = "studio { ambient 1 1 1 }\n";
  for (const CubeFace& face : cube_faces()) {
    text += "surface { diffuse " + words(face.colour) + " } polygon { points 4";
    for (const Vector3d& corner : face.corners)
      text += " vertex " + fmt::format("{:.17g} {:.17g} {:.17g}", (corner.x() - 3) * scale,
                                       (corner.y() + 5) * scale, (corner.z() - 7) * scale);
    text += " }\n";
  }
  return scene_of(text);
}

SampleFile cube_ply(const std::string& format, bool colours_of_vertices) {
  const bool text = format == "ascii", big = format == "binary_big_endian";
  const std::string colour = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  std::string file = "ply\nformat " + format + " 1.0\ncomment made by a test\nelement vertex 24\n" +
                     "property float x\nproperty float y\nproperty float z\n" +
                     (colours_of_vertices ? colour : "") +
                     "element face 6\nproperty list uchar int vertex_indices\n" +
                     (colours_of_vertices ? "" : colour) + "end_header\n";
  const auto add_colour = [&](const Vector3d& rgb) {
    for (const double x : rgb)
      file += text ? fmt::format(" {}", 255 * x) : bytes_of(x > 0 ? 255 : 0, 1);
  };
  for (const CubeFace& face : cube_faces())
    for (const Vector3d& corner : face.corners) {
      for (const double x : corner) file += text ? fmt::format("{} ", x) : float_bytes(x, big);
      if (colours_of_vertices) add_colour(face.colour);
      if (text) file += "\n";
    }
  for (unsigned k = 0; k < 6; ++k) {
    file += text ? fmt::format("{}", 4) : bytes_of(4, 1);
    for (unsigned c = 4 * k; c < 4 * k + 4; ++c)
      file += text ? fmt::format(" {}", c) : bytes_of(c, 4, big);
    if (!colours_of_vertices) add_colour(cube_faces()[k].colour);
    if (text) file += "\n";
  }
  return {"cube.ply", file};
}

SampleFile cube_off(bool colours_of_vertices) {
  std::string file = colours_of_vertices ? "COFF\n24 6 0\n" : "OFF # a cube\n24 6 0\n";
  for (const CubeFace& face : cube_faces())
    for (const Vector3d& corner : face.corners)
      file += words(corner) +
              (colours_of_vertices ? fmt::format(" {} 255", rgb_words(face.colour)) : "") + "\n";
  for (std::size_t k = 0; k < 6; ++k)
    file += fmt::format("4 {} {} {} {} {}\n", 4 * k, 4 * k + 1, 4 * k + 2, 4 * k + 3,
                        colours_of_vertices ? "" : rgb_words(cube_faces()[k].colour));
  return {"cube.off", file};
}

SampleFile cube_binary_stl(bool magics) {
  std::string header = magics ? "COLOR=" + std::string("\0\xff\0\xff", 4) : "cube";
  header.resize(80, ' ');
  std::string file = header + bytes_of(12, 4);
  for (const CubeFace& face : cube_faces()) {
    std::uint64_t attribute = magics ? 0 : 1u << 15;
    for (unsigned k = 0; k < 3; ++k)
      if (face.colour[k] > 0) attribute |= 31u << 5 * (magics ? k : 2 - k);
    // The third face's colour is the header's.
    if (magics && face.name == "side2") attribute = 1u << 15;
    for (const auto& triangle : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}}) {
      file += std::string(12, '\0');
      for (const std::size_t corner : triangle)
        for (const double x : face.corners[corner]) file += float_bytes(x);
      file += bytes_of(attribute, 2);
    }
  }
  return {"cube.stl", file};
}

SampleFile cube_text_stl() {
  std::string file;
  for (const CubeFace& face : cube_faces()) {
    file += "solid " + face.name + "\n";
    for (const auto& triangle : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}}) {
      file += "facet normal 0 0 0\nouter loop\n";
      for (const std::size_t corner : triangle)
        file += "vertex " + words(face.corners[corner]) + "\n";
      file += "endloop\nendfacet\n";
    }
    file += "endsolid " + face.name + "\n";
  }
  return {"cube.stl", file};
}

SampleFile cube_dxf_faces(bool by_layer) {
  std::string file = "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n";
  for (const CubeFace& face : cube_faces())
    file += fmt::format("0\nLAYER\n2\n{}\n70\n0\n62\n{}\n", face.name, face.aci);
  file += "0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  for (const CubeFace& face : cube_faces()) {
    file += fmt::format("0\n3DFACE\n8\n{}\n", by_layer ? face.name.c_str() : "0");
    if (!by_layer)
      file += fmt::format("62\n7\n420\n{}\n", 0xff0000 * int(face.colour[0]) +
                                                  0xff00 * int(face.colour[1]) +
                                                  0xff * int(face.colour[2]));
    for (int k = 0; k < 4; ++k)
      file += dxf_point(10 + k, face.corners[static_cast<std::size_t>(k)]);
  }
  return {"cube.dxf", file + "0\nENDSEC\n0\nEOF\n"};
}

SampleFile cube_dxf_polyface() {
  std::string file =
      "  0\r\nSECTION\r\n  2\r\nENTITIES\r\n0\nPOLYLINE\n8\n0\n66\n1\n70\n64\n71\n24\n72\n6\n";
  for (const CubeFace& face : cube_faces())
    for (const Vector3d& corner : face.corners)
      file += "0\nVERTEX\n8\n0\n70\n192\n" + dxf_point(10, corner);
  for (int k = 0; k < 6; ++k)
    file += fmt::format("0\nVERTEX\n8\n0\n62\n{}\n70\n128\n71\n{}\n72\n{}\n73\n-{}\n74\n{}\n",
                        cube_faces()[static_cast<std::size_t>(k)].aci, 4 * k + 1, 4 * k + 2,
                        4 * k + 3, 4 * k + 4);
  return {"cube.dxf", file + "0\nSEQEND\n0\nENDSEC\n0\nEOF\n"};
}

SampleFile cube_mtl() {
  std::string file;
  for (const CubeFace& face : cube_faces())
    file += "newmtl " + face.name + "\nKd " + words(face.colour) + "\n";
  return {"cube.mtl", file};
}

SampleFile cube_obj() {
  std::string file = "mtllib cube.mtl\n";
  for (const CubeFace& face : cube_faces()) {
    for (const Vector3d& corner : face.corners) file += "v " + words(corner) + "\n";
    file += "usemtl " + face.name + "\nf -4 -3 -2 -1\n";
  }
  return {"cube.obj", file};
}

SampleFile cube_gltf() {
  return {"cube.gltf", gltf_json("\"uri\":\"data:application/octet-stream;base64," +
                                 base64(gltf_buffer()) + "\",")};
}

SampleFile cube_glb() {
  std::string json = gltf_json("");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string buffer = gltf_buffer();
  return {"cube.glb", "glTF" + bytes_of(2, 4) + bytes_of(28 + json.size() + buffer.size(), 4) +
                          bytes_of(json.size(), 4) + "JSON" + json + bytes_of(buffer.size(), 4) +
                          std::string("BIN\0", 4) + buffer};
}

std::string base64(const std::string& bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t word = 0;
    for (std::size_t c = 0; c < 3; ++c)
      word = word << 8 | (k + c < bytes.size() ? static_cast<std::uint8_t>(bytes[k + c]) : 0u);
    for (std::size_t c = 0; c < 4; ++c)
      text += k + c <= bytes.size() ? kDigits[word >> (18 - 6 * c) & 63u] : '=';
  }
  return text;
}

}  // namespace aspect
