#include "tools/export/formats/graph_node.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>

namespace aspect {
namespace {

constexpr std::array<std::string_view, 4> kShapes = {"cir", "sqr", "tri", "oth"};  // by ShapeClass
constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
constexpr std::string_view kFinderLetters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.-";

void read_numbers(TextLines& lines, std::string_view key, std::string_view what, std::int64_t least,
                  std::span<std::int64_t> numbers) {
  lines.expect(key);
  lines.expect("(");
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (k > 0) lines.expect(",");
    numbers[k] = lines.whole(what, least, kMostAttribute);
  }
  lines.expect(")");
}

ShapeClass read_shape(TextLines& lines) {
  for (std::size_t k = 0; k < kShapes.size(); ++k)
    if (lines.accept(kShapes[k])) return static_cast<ShapeClass>(k);
  lines.fail("the shape is none of cir, sqr, tri, oth");
}

}  // namespace

// Digits run from A = 1 to Z = 26.
std::string name_of_place(std::size_t place) {
  std::string name;
  for (std::size_t rest = place + 1; rest > 0; rest = (rest - 1) / 26)
    name.insert(name.begin(), kLetters[(rest - 1) % 26]);
  return name;
}

std::size_t place_of_name(std::string_view name) {
  std::size_t place = 0;
  for (const char letter : name) place = place * 26 + static_cast<std::size_t>(letter - 'A') + 1;
  return place - 1;
}

void append_node(const GraphNode& node, std::string& text) {
  const AttributeVector& a = node.attributes;
  fmt::format_to(std::back_inserter(text),
                 "[{}[@id={};{}:{}:aa({}):mm({},{},{},{}):cg({},{}):cr({},{},{})]]", node.name,
                 node.finder, node.external ? "ext" : "int",
                 kShapes[static_cast<std::size_t>(node.shape)], a[0], a[1], a[2], a[3], a[4], a[5],
                 a[6], a[7], a[8], a[9]);
}

GraphNode read_node(TextLines& lines) {
  GraphNode node;
  lines.expect("[");
  node.name = lines.run_of(kLetters, "a contour id");
  if (node.name.size() > 4)
    lines.fail(excerpt_of(node.name) + " is no contour id of up to 4 letters");
  lines.expect("[");
  lines.expect("@id");
  lines.expect("=");
  node.finder = lines.run_of(kFinderLetters, "the name of who found the contour");
  lines.expect(";");
  node.external = lines.accept("ext");
  if (!node.external) lines.expect("int");
  lines.expect(":");
  node.shape = read_shape(lines);
  const std::span<std::int64_t> a = node.attributes;
  lines.expect(":");
  read_numbers(lines, "aa", "number of pixels", 0, a.subspan(0, 1));
  lines.expect(":");
  read_numbers(lines, "mm", "moment", -kMostAttribute, a.subspan(1, 4));
  lines.expect(":");
  read_numbers(lines, "cg", "coordinate", -kMostAttribute, a.subspan(5, 2));
  lines.expect(":");
  read_numbers(lines, "cr", "colour", 0, a.subspan(7, 3));
  lines.expect("]");
  lines.expect("]");
  return node;
}

}  // namespace aspect
