#include "compiler/scene/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace aspect {
namespace {

constexpr std::size_t kMaxElements = 100, kMaxProperties = 1000, kMaxTextures = 1000;

PlyType type_of(const MeshText& text, std::string_view word) {
  constexpr std::array<std::array<std::string_view, 2>, 8> kNames = {{{"char", "int8"},
                                                                      {"uchar", "uint8"},
                                                                      {"short", "int16"},
                                                                      {"ushort", "uint16"},
                                                                      {"int", "int32"},
                                                                      {"uint", "uint32"},
                                                                      {"float", "float32"},
                                                                      {"double", "float64"}}};
  for (std::size_t k = 0; k < kNames.size(); ++k)
    if (word == kNames[k][0] || word == kNames[k][1]) return static_cast<PlyType>(k);
  text.fail(fmt::format("unknown type '{}'; export it again", shown(word)));
}

void read_format(const MeshText& text, const std::vector<std::string_view>& words,
                 PlyHeader& header) {
  const std::string_view name = words.size() > 1 ? words[1] : std::string_view{};
  if (name == "ascii")
    header.format = PlyHeader::Format::text;
  else if (name == "binary_little_endian")
    header.format = PlyHeader::Format::little_endian;
  else if (name == "binary_big_endian")
    header.format = PlyHeader::Format::big_endian;
  else
    text.fail(fmt::format("unknown format '{}'; write ascii or binary", shown(name)));
}

void read_property(const MeshText& text, const std::vector<std::string_view>& words,
                   PlyHeader& header) {
  if (header.elements.empty() || header.elements.back().properties.size() == kMaxProperties)
    text.fail("a property outside of an element, or too many; export it again");
  PlyProperty property;
  property.list = words.size() == 5 && words[1] == "list";
  if (!property.list && words.size() != 3) text.fail("a property without type and name");
  property.type = type_of(text, words[words.size() - 2]);
  property.name = words.back();
  if (property.list) property.count_type = type_of(text, words[2]);
  header.elements.back().properties.push_back(std::move(property));
}

// A name may hold spaces.
void add_texture(const MeshText& text, std::string_view line, std::string_view first_word,
                 PlyHeader& header) {
  if (header.textures.size() == kMaxTextures) text.fail("too many textures; export it again");
  const auto begin = static_cast<std::size_t>(first_word.data() - line.data());
  const std::size_t end = line.find_last_not_of(" \t\r") + 1;
  header.textures.push_back({std::string(line.substr(begin, end - begin)), text.line()});
}

}  // namespace

std::size_t PlyElement::find(std::initializer_list<std::string_view> names) const {
  for (std::size_t k = 0; k < properties.size(); ++k)
    if (std::find(names.begin(), names.end(), properties[k].name) != names.end()) return k;
  return properties.size();
}

std::size_t bytes_of(PlyType type) {
  constexpr std::array<std::size_t, 8> kBytes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kBytes[static_cast<std::size_t>(type)];
}

double full_scale(PlyType type) {
  constexpr std::array<double, 8> kScale = {127, 255, 32767, 65535, 255, 255, 1, 1};
  return kScale[static_cast<std::size_t>(type)];
}

PlyHeader read_ply_header(MeshText& text) {
  if (text.take_line() != "ply") text.fail("does not start with ply; export it again");
  PlyHeader header;
  while (!text.at_end()) {
    const std::string_view line = text.take_line();
    const std::vector<std::string_view> words = words_of(line);
    if (words.empty() || words[0] == "obj_info") continue;
    if (words[0] == "end_header") return header;
    if (words[0] == "comment") {
      if (words.size() > 2 && words[1] == "TextureFile") add_texture(text, line, words[2], header);
    } else if (words[0] == "format") {
      read_format(text, words, header);
    } else if (words[0] == "element" && words.size() == 3) {
      if (header.elements.size() == kMaxElements) text.fail("too many elements; export it again");
      const std::size_t count = text.count(words[2], ColouredMesh::kMaxVertices);
      header.elements.push_back({std::string(words[1]), count, {}});
    } else if (words[0] == "property") {
      read_property(text, words, header);
    } else {
      text.fail(fmt::format("unknown word '{}' in the header; export it again", shown(words[0])));
    }
  }
  text.fail("the header has no end_header; export it again");
}

}  // namespace aspect
