// Idea: the whole file is read, then the libraries that it names, wherever they are named; then a
// part's paint is looked up when the first face needs it, so that a colour that nothing shows is
// not missed.
#include "compiler/scene/obj_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "compiler/scene/bob_sources.h"
#include "compiler/scene/mesh_text.h"
#include "compiler/scene/mtl_library.h"
#include "compiler/scene/named_file.h"
#include "compiler/scene/obj_file.h"
#include "compiler/scene/textured_faces.h"
#include "runtime/base/nearest_word.h"

namespace aspect {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t kMaxLibraryBytes = std::size_t{64} << 20;

// What the faces of a part show, unless their corners have colours.
struct Paint {
  Vector3d colour = kUncoloured;
  bool coloured = false;  // by a material, or missing
  TexturedFaces::Picture* picture = nullptr;
  PictureFactor factor = {};
  const MtlMaterial* material = nullptr;
  bool told_without_coordinates = false;
};

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::filesystem::path& file, const Vector3d& stand_in)
      : file_(file), stand_in_(stand_in), obj_(read_obj_file(text)), paints_(obj_.parts.size()) {}

  ColouredMesh read() {
    mesh_.vertices = obj_.vertices;
    mesh_.warnings = obj_.warnings;
    for (const ObjFile::Part& part : obj_.parts) mesh_.parts.push_back({part.name, part.material});
    for (const ObjFile::Library& library : obj_.libraries) load(library);
    std::size_t uncoloured = 0, faces = 0;
    for (const ObjFile::Face& face : obj_.faces) {
      try {
        if (face.corner_count < 3) continue;
        ++faces;
        if (!add(face)) ++uncoloured;
      } catch (const MeshError& error) {
        throw MeshError(error.what(), error.line() != 0 ? error.line() : face.line, error.file());
      }
    }
    textured_.add_to(mesh_);
    warn_of_uncoloured(mesh_, uncoloured, faces);
    warn_of_unneeded_libraries();
    return std::move(mesh_);
  }

 private:
  struct LostLibrary {
    std::string name;
    std::size_t line;
    std::optional<std::size_t> missing;  // its place in mesh_.missing
  };

  // A name with spaces, or several names.
  void load(const ObjFile::Library& library) {
    if (load_file(library.names, library.line)) return;
    const std::vector<std::string_view> names = words_of(library.names);
    std::vector<std::string> lost;
    for (const std::string_view name : names)
      if (names.size() == 1 || !load_file(name, library.line)) lost.emplace_back(name);
    if (lost.size() == names.size()) lost = {library.names};
    for (std::string& name : lost) lost_.push_back({std::move(name), library.line, {}});
  }

  bool load_file(std::string_view name, std::size_t line) {
    const std::optional<NamedFile> found = find_named_file(file_.parent_path(), name, mesh_.files);
    if (!found) return false;
    if (found->guessed)
      mesh_.warnings.push_back(fmt::format("mtllib '{}' of line {} is taken to be {}", shown(name),
                                           line, found->path.string()));
    const Result<std::string> text = load_text(found->path, kMaxLibraryBytes);
    if (!text) throw MeshError(text.error(), 0, found->path.string());
    read_mtl(text.value(), found->path, materials_, mesh_.warnings);
    return true;
  }

  // Whether the face has a colour of its own or of a material.
  bool add(const ObjFile::Face& face) {
    const std::span<const ObjCorner> corners(&obj_.corners[face.first_corner], face.corner_count);
    const std::optional<Vector3d> own = obj_.coloured ? own_colour(corners) : std::nullopt;
    if (own && !is_painted(face.part)) {
      add_plain(corners, *own, face.part);
      return true;
    }
    Paint& paint = paint_of(face.part);
    if (obj_.coloured && !own && !paint.coloured)
      throw MeshError(
          "a face whose vertices have no colour, while others have; give all of them one");
    if (paint.picture != nullptr)
      add_textured(corners, paint, face);
    else
      add_plain(corners, own.value_or(paint.colour), face.part);
    return own || paint.coloured;
  }

  std::optional<Vector3d> own_colour(std::span<const ObjCorner> corners) const {
    Vector3d sum = Vector3d::Zero();
    std::size_t count = 0;
    for (const ObjCorner& corner : corners)
      if (const auto& colour = obj_.colours[corner.vertex]) sum += *colour, ++count;
    if (count == 0) return std::nullopt;
    if (count < corners.size())
      throw MeshError(
          "a face with vertices of which some have a colour and some not; give all of them one");
    return sum / static_cast<double>(count);
  }

  // A picture wins over the colours of vertices.
  bool is_painted(std::uint32_t part) const {
    const auto found = materials_.find(obj_.parts[part].material);
    return found != materials_.end() && !found->second.picture.empty();
  }

  void add_plain(std::span<const ObjCorner> corners, const Vector3d& colour, std::uint32_t part) {
    indices_.clear();
    for (const ObjCorner& corner : corners) indices_.push_back(corner.vertex);
    add_face(mesh_, indices_, colour, part);
  }

  void add_textured(std::span<const ObjCorner> corners, Paint& paint, const ObjFile::Face& face) {
    std::vector<Vector3d> places;
    std::vector<Vector2d> uv;
    for (const ObjCorner& corner : corners) {
      if (!corner.uv) return add_without_coordinates(corners, paint, face);
      places.push_back(obj_.vertices[corner.vertex]);
      uv.push_back(obj_.uv[*corner.uv].cwiseProduct(paint.material->picture_scale) +
                   paint.material->picture_offset);
    }
    TexturedFaces::add(*paint.picture, places, uv, paint.factor, face.part);
  }

  void add_without_coordinates(std::span<const ObjCorner> corners, Paint& paint,
                               const ObjFile::Face& face) {
    if (!std::exchange(paint.told_without_coordinates, true))
      add_missing(
          {{},
           face.line,
           fmt::format("a face without texture coordinates has material '{}', which is a picture",
                       shown(obj_.parts[face.part].material)),
           "export it with them",
           {face.part}});
    add_plain(corners, stand_in_, face.part);
  }

  Paint& paint_of(std::uint32_t part) {
    if (!paints_[part]) paints_[part] = find_paint(part);
    return *paints_[part];
  }

  Paint find_paint(std::uint32_t part) {
    const std::string& name = obj_.parts[part].material;
    const auto found = materials_.find(name);
    if (found != materials_.end()) return paint_of(found->first, found->second, part);
    if (!lost_.empty()) {
      add_lost_library(part);
      return {stand_in_, true};
    }
    if (name.empty()) return {};
    if (obj_.libraries.empty()) {
      add_without_library(part);
      return {stand_in_, true};
    }
    std::vector<std::string_view> known;
    for (const auto& [material, paint] : materials_) known.push_back(material);
    const std::string hint =
        known.empty() ? "the libraries are empty; export them again"
                      : fmt::format("the nearest one there is '{}'", nearest_word(name, known));
    add_missing({{},
                 obj_.parts[part].material_line,
                 fmt::format("usemtl '{}' is in no library", shown(name)),
                 hint,
                 {part}});
    return {stand_in_, true};
  }

  Paint paint_of(const std::string& name, const MtlMaterial& material, std::uint32_t part) {
    Paint paint{material.colour.value_or(kUncoloured), true};
    paint.material = &material;
    const std::string library = material.library.string();
    if (!material.picture.empty()) {
      TexturedFaces::Picture& picture = picture_of(material);
      // Many writers leave the colour beside a texture black.
      if (material.colour && !material.colour->isZero()) paint.factor.factor = *material.colour;
      if (picture.texture) {
        paint.picture = &picture;
        return paint;
      }
      add_missing({library,
                   material.picture_line,
                   fmt::format("map_Kd '{}' {}", shown(material.picture), picture.fault),
                   "put a PNG or JPEG picture there",
                   {part}});
      paint.colour = stand_in_;
    } else if (!material.unread.empty() && !material.colour) {
      add_missing({library,
                   material.colour_line,
                   fmt::format("Kd of '{}' is {}", shown(name), material.unread),
                   "write Kd r g b",
                   {part}});
      paint.colour = stand_in_;
    } else if (!material.colour && colourless_.insert(name).second) {
      mesh_.warnings.push_back(
          fmt::format("material '{}' has no colour (Kd); it is grey", shown(name)));
    }
    return paint;
  }

  TexturedFaces::Picture& picture_of(const MtlMaterial& material) {
    std::optional<NamedFile> found =
        find_named_file(material.library.parent_path(), material.picture, mesh_.files);
    if (!found) found = find_named_file(file_.parent_path(), material.picture, mesh_.files);
    const std::string key = found ? found->path.string() : material.picture;
    return textured_.picture(key, [&]() -> std::vector<std::uint8_t> {
      if (!found) throw MeshError("is not there");
      if (found->guessed)
        mesh_.warnings.push_back(fmt::format("map_Kd '{}' is taken to be {}",
                                             shown(material.picture), found->path.string()));
      return load_picture(found->path);
    });
  }

  // One fault, however many materials it costs.
  void add_without_library(std::uint32_t part) {
    if (!without_library_) {
      without_library_ = mesh_.missing.size();
      mesh_.missing.push_back({{},
                               obj_.parts[part].material_line,
                               fmt::format("usemtl '{}' is in no library, since mtllib names none",
                                           shown(obj_.parts[part].material)),
                               "name the library by mtllib",
                               {}});
    }
    mesh_.missing[*without_library_].parts.push_back(part);
  }

  void add_lost_library(std::uint32_t part) {
    LostLibrary& lost = lost_.front();
    if (!lost.missing) {
      lost.missing = mesh_.missing.size();
      mesh_.missing.push_back({{},
                               lost.line,
                               fmt::format("mtllib '{}' is not there", shown(lost.name)),
                               "put it beside the OBJ file"});
    }
    mesh_.missing[*lost.missing].parts.push_back(part);
  }

  // What several parts lack is told once.
  void add_missing(MissingColour missing) {
    const auto [told, added] =
        told_.try_emplace(missing.file + '\n' + missing.what, mesh_.missing.size());
    if (added) return mesh_.missing.push_back(std::move(missing));
    std::vector<std::uint32_t>& parts = mesh_.missing[told->second].parts;
    parts.insert(parts.end(), missing.parts.begin(), missing.parts.end());
  }

  void warn_of_unneeded_libraries() {
    for (const LostLibrary& lost : lost_)
      if (!lost.missing && !lost_.front().missing)
        mesh_.warnings.push_back(
            fmt::format("mtllib '{}' of line {} is not there", shown(lost.name), lost.line));
  }

  const std::filesystem::path& file_;
  const Vector3d stand_in_;
  const ObjFile obj_;
  MtlMaterials materials_;
  std::vector<LostLibrary> lost_;
  std::vector<std::optional<Paint>> paints_;  // by part
  TexturedFaces textured_;
  std::vector<std::uint32_t> indices_;
  std::map<std::string, std::size_t> told_;     // places in mesh_.missing
  std::set<std::string> colourless_;            // materials, warned of
  std::optional<std::size_t> without_library_;  // its place in mesh_.missing
  ColouredMesh mesh_;
};

}  // namespace

ColouredMesh parse_obj(std::string_view text, const std::filesystem::path& file,
                       const Vector3d& stand_in) {
  return ObjReader(text, file, stand_in).read();
}

}  // namespace aspect
