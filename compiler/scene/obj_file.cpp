#include "compiler/scene/obj_file.h"

#include <fmt/format.h>

#include <charconv>
#include <limits>

#include "compiler/scene/coloured_mesh.h"
#include "compiler/scene/mesh_text.h"

namespace aspect {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Words = std::vector<std::string_view>;

constexpr std::size_t kMostCorners = 3 * ColouredMesh::kMaxTriangles;

// Some writers have texture coordinates that are no numbers where there is no picture either.
double number_or_nan(std::string_view word) {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(word.data(), word.data() + word.size(), value);
  return value;
}

class ObjFileReader {
 public:
  explicit ObjFileReader(std::string_view text) : text_(without_byte_order_mark(text)) {}

  ObjFile read() {
    while (!text_.at_end()) statement(take_whole_line());
    for (std::size_t k = 0; k < obj_.faces.size(); ++k) check(obj_.faces[k]);
    scale_colours();
    return std::move(obj_);
  }

 private:
  // With the lines that backslashes at their ends join to it.
  std::string_view take_whole_line() {
    std::string_view line = text_.take_line();
    if (!line.ends_with('\\')) return line;
    joined_.clear();
    while (line.ends_with('\\')) {
      joined_ += line.substr(0, line.size() - 1);
      joined_ += ' ';
      line = text_.take_line();
    }
    joined_ += line;
    return joined_;
  }

  void statement(std::string_view line) {
    const Words words = words_of(line.substr(0, line.find('#')));
    if (words.empty()) return;
    if (words[0] == "v") return vertex(words);
    if (words[0] == "vt") return texture_coordinates(words);
    if (words[0] == "f" || words[0] == "fo") return face(words);
    const std::string keyword = lower_case(words[0]);
    // Names may hold a '#'.
    const std::string name(rest_of_line(line, words_of(line)[0]));
    if (keyword == "o" || keyword == "g") return begin_part(name, part_.material);
    if (keyword == "usemtl") {
      part_.material_line = text_.line();
      return begin_part(part_.name, name);
    }
    if (keyword == "mtllib") obj_.libraries.push_back({name, text_.line()});
  }

  void vertex(const Words& words) {
    if (words.size() < 4) text_.fail("a vertex of fewer than 3 numbers; export it again");
    if (obj_.vertices.size() == ColouredMesh::kMaxVertices)
      text_.fail(
          fmt::format("more than {} vertices; simplify the model", ColouredMesh::kMaxVertices));
    obj_.vertices.push_back(numbers(words, 1));
    // Four numbers are x y z w; seven end in an alpha.
    const bool coloured = words.size() >= 7;
    obj_.colours.push_back(coloured ? std::optional(numbers(words, 4)) : std::nullopt);
    obj_.coloured = obj_.coloured || coloured;
  }

  void texture_coordinates(const Words& words) {
    if (words.size() < 2) text_.fail("vt without a number; export it again");
    obj_.uv.emplace_back(number_or_nan(words[1]), words.size() > 2 ? number_or_nan(words[2]) : 0);
  }

  Vector3d numbers(const Words& words, std::size_t first) const {
    return {text_.number(words[first]), text_.number(words[first + 1]),
            text_.number(words[first + 2])};
  }

  void begin_part(std::string name, std::string material) {
    part_.name = std::move(name);
    part_.material = std::move(material);
    part_begins_ = true;
  }

  void face(const Words& words) {
    if (words.size() - 1 > ColouredMesh::kMaxFaceCorners)
      text_.fail(fmt::format("a face of {} corners, at most {} are read; write triangles",
                             words.size() - 1, ColouredMesh::kMaxFaceCorners));
    if (obj_.corners.size() + words.size() > kMostCorners)
      text_.fail(fmt::format("more than {} corners of faces; simplify the model", kMostCorners));
    if (part_begins_) obj_.parts.push_back(part_);
    part_begins_ = false;
    obj_.faces.push_back({obj_.corners.size(), words.size() - 1,
                          static_cast<std::uint32_t>(obj_.parts.size() - 1), text_.line()});
    for (std::size_t k = 1; k < words.size(); ++k) obj_.corners.push_back(corner(words[k]));
  }

  // v, v/vt, v/vt/vn or v//vn.
  ObjCorner corner(std::string_view word) const {
    const std::size_t slash = word.find('/');
    ObjCorner made;
    made.vertex = index(word.substr(0, slash), obj_.vertices.size());
    if (slash == std::string_view::npos) return made;
    const std::string_view rest = word.substr(slash + 1);
    const std::string_view uv = rest.substr(0, rest.find('/'));
    if (!uv.empty()) made.uv = index(uv, obj_.uv.size());
    return made;
  }

  // From 1, or from -1 backwards from the last one so far.
  std::uint32_t index(std::string_view word, std::size_t so_far) const {
    std::int64_t number = 0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (number < 0) number += static_cast<std::int64_t>(so_far) + 1;
    if (fault != std::errc{} || end != word.data() + word.size() || number < 1 ||
        number > UINT32_MAX)
      text_.fail(fmt::format("'{}' is no vertex that is there; export it again", shown(word)));
    return static_cast<std::uint32_t>(number - 1);
  }

  // Vertices may follow the faces that have them.
  void check(const ObjFile::Face& face) const {
    for (std::size_t k = 0; k < face.corner_count; ++k) {
      const ObjCorner& corner = obj_.corners[face.first_corner + k];
      if (corner.vertex >= obj_.vertices.size())
        throw MeshError(fmt::format("a face has vertex {}, but there are {}; export it again",
                                    corner.vertex + 1, obj_.vertices.size()),
                        face.line);
      if (corner.uv && *corner.uv >= obj_.uv.size())
        throw MeshError(fmt::format("a face has texture coordinates {}, but there are {}; export "
                                    "it again",
                                    *corner.uv + 1, obj_.uv.size()),
                        face.line);
    }
  }

  void scale_colours() {
    double most = 0;
    for (const auto& colour : obj_.colours)
      if (colour) most = std::max(most, colour->maxCoeff());
    if (most <= 1) return;
    for (auto& colour : obj_.colours)
      if (colour) *colour /= 255;
    obj_.warnings.push_back("colours of vertices are above 1 and read as parts of 255");
  }

  MeshText text_;
  std::string joined_;
  ObjFile obj_;
  ObjFile::Part part_;
  bool part_begins_ = true;
};

}  // namespace

ObjFile read_obj_file(std::string_view text) {
  std::string held;
  return ObjFileReader(with_line_feeds(text, held)).read();
}

}  // namespace aspect
