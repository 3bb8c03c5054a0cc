#include "compiler/scene/ply_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "compiler/scene/ply_faces.h"
#include "compiler/scene/ply_header.h"
#include "compiler/scene/ply_numbers.h"

namespace aspect {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Where an element keeps its colour.
struct Channels {
  explicit Channels(const PlyElement& element)
      : at{element.find({"red", "diffuse_red", "r"}), element.find({"green", "diffuse_green", "g"}),
           element.find({"blue", "diffuse_blue", "b"})} {
    for (const std::size_t k : at) there = there && k < element.properties.size();
    if (there) scale = full_scale(element.properties[at[0]].type);
  }
  Vector3d of(const std::vector<double>& row) const {
    return Vector3d(row[at[0]], row[at[1]], row[at[2]]) / scale;
  }

  std::array<std::size_t, 3> at;
  bool there = true;
  double scale = 1;
};

// Where an element keeps its texture coordinates.
struct Texcoords {
  explicit Texcoords(const PlyElement& element)
      : at{element.find({"s", "u", "texture_s", "texture_u"}),
           element.find({"t", "v", "texture_t", "texture_v"})} {
    for (const std::size_t k : at)
      there = there && k < element.properties.size() && !element.properties[k].list;
  }
  Vector2d of(const std::vector<double>& row) const { return {row[at[0]], row[at[1]]}; }

  std::array<std::size_t, 2> at;
  bool there = true;
};

class PlyReader {
 public:
  PlyReader(std::string_view bytes, MeshText& text, const Vector3d& stand_in)
      : header_(read_ply_header(text)), numbers_(bytes, text, header_.format), stand_in_(stand_in) {
    mesh_.parts.push_back({});
  }

  ColouredMesh read(const std::filesystem::path& folder) {
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      if (element.name == "vertex")
        read_vertices(element);
      else if (element.name == "face")
        read_faces(element);
      else if (element.name == "multi_texture_vertex")
        read_texture_vertices(element);
      else if (element.name == "multi_texture_face")
        read_texture_faces(element);
      else
        skip(element);
    }
    tell_of_missing_colours();
    add_ply_faces(mesh_, faces_, header_.textures, folder, stand_in_);
    return std::move(mesh_);
  }

 private:
  // One element's numbers by property; those of lists into lists_.
  void read_row(const PlyElement& element) {
    constexpr std::size_t kMaxList = 2 * ColouredMesh::kMaxFaceCorners;  // texture coordinates
    row_.assign(element.properties.size(), 0);
    if (lists_.size() < row_.size()) lists_.resize(row_.size());
    for (std::size_t k = 0; k < row_.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      if (!property.list) {
        row_[k] = numbers_.next(property.type);
        continue;
      }
      const double count = numbers_.next(property.count_type);
      if (!(count >= 0 && count <= static_cast<double>(kMaxList)))
        throw MeshError(
            fmt::format("a list of {:g} numbers, at most {} are read", count, kMaxList));
      lists_[k].clear();
      for (int left = static_cast<int>(count); left > 0; --left)
        lists_[k].push_back(numbers_.next(property.type));
    }
  }

  void read_vertices(const PlyElement& element) {
    const std::array<std::size_t, 3> at = {element.find({"x"}), element.find({"y"}),
                                           element.find({"z"})};
    for (const std::size_t k : at)
      if (k == element.properties.size()) throw MeshError("vertices without x, y and z");
    const Channels channels(element);
    const Texcoords texcoords(element);
    coloured_ = coloured_ || channels.there;
    for (std::size_t left = element.count; left > 0; --left) {
      read_row(element);
      add_vertex(mesh_, {row_[at[0]], row_[at[1]], row_[at[2]]});
      vertex_colours_.push_back(channels.there ? channels.of(row_) : kUncoloured);
      if (texcoords.there) vertex_texcoords_.push_back(texcoords.of(row_));
    }
    vertex_texcoords_.resize(texcoords.there ? mesh_.vertices.size() : 0);
    has_texcoords_ = has_texcoords_ || texcoords.there;
  }

  void read_faces(const PlyElement& element) {
    const std::size_t none = element.properties.size();
    const std::size_t list = list_of(element, {"vertex_indices", "vertex_index"});
    if (list == none) throw MeshError("faces without a list vertex_indices; export it again");
    const std::size_t texcoords = list_of(element, {"texcoord"});
    const std::size_t texnumber = element.find({"texnumber"});
    const Channels channels(element);
    coloured_ = coloured_ || channels.there;
    has_texcoords_ = has_texcoords_ || texcoords < none;
    for (std::size_t left = element.count; left > 0; --left) {
      read_row(element);
      read_corners(lists_[list], mesh_.vertices.size(), "a face");
      Vector3d mean = Vector3d::Zero();
      for (const std::uint32_t corner : corners_)
        mean += vertex_colours_[corner] / static_cast<double>(corners_.size());
      faces_.add(corners_, channels.there ? channels.of(row_) : mean);
      if (header_.textures.empty()) continue;
      if (!(texcoords < none ? take_texcoords(lists_[texcoords]) : take_texcoords_of_vertices()))
        continue;
      if (texnumber == none && header_.textures.size() > 1)
        throw MeshError(fmt::format("names {} textures, but not which of them a face has "
                                    "(texnumber); export it again",
                                    header_.textures.size()),
                        header_.textures[1].line);
      set_texture(faces_.faces.size() - 1, texnumber < none ? row_[texnumber] : 0);
    }
  }

  // The element's list of that name, or the number of its properties.
  static std::size_t list_of(const PlyElement& element,
                             std::initializer_list<std::string_view> names) {
    const std::size_t k = element.find(names);
    return k < element.properties.size() && element.properties[k].list ? k
                                                                       : element.properties.size();
  }

  void read_corners(const std::vector<double>& list, std::size_t count, std::string_view what) {
    corners_.clear();
    for (const double index : list) {
      if (!(index >= 0 && index < static_cast<double>(count)))
        throw MeshError(fmt::format("{} has vertex {:g}, but there are {}; export it again", what,
                                    index, count));
      corners_.push_back(static_cast<std::uint32_t>(index));
    }
  }

  // Into texcoords_, those of the face in corners_; false where it has none.
  bool take_texcoords(const std::vector<double>& list) {
    if (list.empty()) return false;
    if (list.size() != 2 * corners_.size())
      throw MeshError(
          fmt::format("a face of {} corners has {} texture coordinates, not {}; "
                      "export it again",
                      corners_.size(), list.size(), 2 * corners_.size()));
    texcoords_.clear();
    for (std::size_t k = 0; k < list.size(); k += 2) texcoords_.emplace_back(list[k], list[k + 1]);
    return true;
  }
  bool take_texcoords_of_vertices() {
    if (vertex_texcoords_.empty()) return false;
    texcoords_.clear();
    for (const std::uint32_t corner : corners_) texcoords_.push_back(vertex_texcoords_[corner]);
    return true;
  }

  // A number below zero says that the face has none.
  void set_texture(std::size_t face, double number) {
    if (number < 0) return;
    if (!(number < static_cast<double>(header_.textures.size())))
      throw MeshError(
          fmt::format("a face has texture {:g}, but the header names {}; write a "
                      "comment TextureFile for each",
                      number, header_.textures.size()));
    faces_.set_texture(face, static_cast<int>(number), texcoords_);
  }

  // Texture coordinates that faces point at, as scanners write them where a vertex has several.
  void read_texture_vertices(const PlyElement& element) {
    const Texcoords texcoords(element);
    if (!texcoords.there) throw MeshError("multi_texture_vertex without u and v; export it again");
    for (std::size_t left = element.count; left > 0; --left) {
      read_row(element);
      texture_vertices_.push_back(texcoords.of(row_));
    }
    has_texcoords_ = true;
  }

  // tx is the texture, tn the face, which may be left out where all faces come in order.
  void read_texture_faces(const PlyElement& element) {
    const std::size_t none = element.properties.size();
    const std::size_t list = list_of(element, {"texture_vertex_indices"});
    const std::size_t texture = element.find({"tx"}), number = element.find({"tn"});
    if (list == none)
      throw MeshError("multi_texture_face without texture_vertex_indices; export it again");
    for (std::size_t k = 0; k < element.count; ++k) {
      read_row(element);
      if (header_.textures.empty() || lists_[list].empty()) continue;
      const double face = number < none ? row_[number] : static_cast<double>(k);
      read_corners(lists_[list], texture_vertices_.size(), "a textured face");
      if (!(face >= 0 && face < static_cast<double>(faces_.faces.size())) ||
          faces_.faces[static_cast<std::size_t>(face)].count != corners_.size())
        throw MeshError(
            fmt::format("multi_texture_face {} does not fit face {:g}; export it again", k, face));
      texcoords_.clear();
      for (const std::uint32_t corner : corners_) texcoords_.push_back(texture_vertices_[corner]);
      set_texture(static_cast<std::size_t>(face), texture < none ? row_[texture] : 0);
    }
  }

  void skip(const PlyElement& element) {
    for (std::size_t left = element.count; left > 0; --left) read_row(element);
  }

  void tell_of_missing_colours() {
    const auto plain = static_cast<std::size_t>(
        std::count_if(faces_.faces.begin(), faces_.faces.end(),
                      [](const PlyFaces::Face& face) { return face.texture == PlyFaces::kPlain; }));
    if (!header_.textures.empty() && !has_texcoords_) {
      const auto& [name, line] = header_.textures[0];
      const std::string fault =
          fmt::format("texture '{}' is named, but there are no texture coordinates", shown(name));
      if (coloured_)
        return mesh_.warnings.push_back(fault + "; the colours of faces or vertices are used");
      mesh_.missing.push_back({{}, line, fault, "export them", {0}});
      for (PlyFaces::Face& face : faces_.faces) face.colour = stand_in_;
    } else if (!coloured_ && plain == faces_.faces.size()) {
      mesh_.warnings.push_back(
          has_texcoords_
              ? "has texture coordinates, but names no texture and holds no colours; all of it is "
                "grey; add comment TextureFile NAME to its header"
              : "holds no colours; all of it is grey");
    } else if (!coloured_ && plain > 0) {
      mesh_.warnings.push_back(
          fmt::format("{} of {} faces have no texture; they are grey", plain, faces_.faces.size()));
    }
  }

  PlyHeader header_;
  PlyNumbers numbers_;
  const Vector3d& stand_in_;
  ColouredMesh mesh_;
  PlyFaces faces_;
  std::vector<Vector3d> vertex_colours_;
  std::vector<Vector2d> vertex_texcoords_, texture_vertices_;
  bool coloured_ = false, has_texcoords_ = false;
  // Of the element that is read.
  std::vector<double> row_;
  std::vector<std::vector<double>> lists_;  // by property
  std::vector<std::uint32_t> corners_;
  std::vector<Vector2d> texcoords_;
};

}  // namespace

ColouredMesh parse_ply(std::string_view bytes, const std::filesystem::path& file,
                       const Vector3d& stand_in) {
  MeshText text(bytes);
  return PlyReader(bytes, text, stand_in).read(file.parent_path());
}

bool names_textures(std::string_view ply_bytes) {
  MeshText text(ply_bytes);
  return !read_ply_header(text).textures.empty();
}

}  // namespace aspect
