#include "compiler/scene/gltf_mesh.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "compiler/scene/gltf_accessor.h"
#include "compiler/scene/gltf_file.h"
#include "compiler/scene/gltf_paint.h"
#include "compiler/scene/mesh_text.h"
#include "compiler/scene/srgb.h"
#include "compiler/scene/textured_faces.h"

namespace aspect {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Json = GltfFile::Json;
using Corners = std::array<std::uint32_t, 3>;

constexpr std::size_t kMostParts = 1'000'000;

// Seven digits, so that the 0.9 of single precision is 0.9 again.
double rounded(double value) {
  return std::round(value * 1e7) / 1e7;
}

Eigen::Affine3d placing_of(const Json& node) {
  Eigen::Affine3d placing = Eigen::Affine3d::Identity();
  const std::vector<double> matrix = number_members(node, "matrix"),
                            move = number_members(node, "translation"),
                            turn = number_members(node, "rotation"),
                            scale = number_members(node, "scale");
  if (matrix.size() == 16) {
    placing.matrix() = Eigen::Map<const Eigen::Matrix4d>(matrix.data());
    placing.makeAffine();
    return placing;
  }
  if (move.size() == 3) placing.translate(Vector3d(move[0], move[1], move[2]));
  if (turn.size() == 4)
    placing.rotate(Eigen::Quaterniond(turn[3], turn[0], turn[1], turn[2]).normalized());
  if (scale.size() == 3) placing.scale(Vector3d(scale[0], scale[1], scale[2]));
  return placing;
}

// The triangles of a primitive's corners: a list, a strip or a fan.
std::vector<Corners> triangles_of(const std::vector<std::uint32_t>& corners, std::size_t mode) {
  constexpr std::size_t kList = 4, kStrip = 5;
  std::vector<Corners> triangles;
  const std::size_t step = mode == kList ? 3 : 1;
  for (std::size_t k = 0; k + 2 < corners.size(); k += step) {
    if (mode == kList)
      triangles.push_back({corners[k], corners[k + 1], corners[k + 2]});
    else if (mode == kStrip)
      triangles.push_back({corners[k], corners[k + 1 + k % 2], corners[k + 2 - k % 2]});
    else
      triangles.push_back({corners[k + 1], corners[k + 2], corners[0]});
  }
  return triangles;
}

// One primitive's numbers.
struct Attributes {
  GltfNumbers positions;
  std::optional<GltfNumbers> colours, uv;
};

class GltfReader {
 public:
  GltfReader(std::string_view bytes, const std::filesystem::path& file, const Vector3d& stand_in)
      : gltf_(bytes, file), stand_in_(stand_in) {}

  ColouredMesh read() {
    add_nodes();
    textured_.add_to(mesh_);
    warn_of_uncoloured(mesh_, uncoloured_, faces_);
    mesh_.files = gltf_.asked();
    return std::move(mesh_);
  }

 private:
  struct Node {
    std::size_t index;
    Eigen::Affine3d parent;
  };

  // The roots of the default scene or, where there is no scene, all nodes that are no children.
  std::vector<std::size_t> roots() const {
    const Json* scene = gltf_.find("scenes", whole_member(gltf_.root(), "scene").value_or(0));
    if (scene != nullptr) return indices_in(*scene, "nodes");
    const auto nodes = gltf_.root().find("nodes");
    std::vector<std::size_t> roots;
    if (nodes == gltf_.root().end() || !nodes->is_array()) return roots;
    std::vector<bool> is_child(nodes->size(), false);
    for (std::size_t k = 0; k < nodes->size(); ++k)
      for (const std::size_t child : indices_in(gltf_.at("nodes", k, "the file"), "children"))
        if (child < is_child.size()) is_child[child] = true;
    for (std::size_t k = 0; k < is_child.size(); ++k)
      if (!is_child[k]) roots.push_back(k);
    return roots;
  }

  static std::vector<std::size_t> indices_in(const Json& object, const char* key) {
    std::vector<std::size_t> indices;
    const auto found = object.find(key);
    if (found == object.end() || !found->is_array()) return indices;
    for (const Json& index : *found) {
      if (!index.is_number_unsigned())
        throw MeshError(fmt::format("{} is no list of nodes; export it again", key));
      indices.push_back(index.get<std::size_t>());
    }
    return indices;
  }

  void add_nodes() {
    std::vector<Node> open;
    const auto push = [&open](const std::vector<std::size_t>& nodes, const Eigen::Affine3d& at) {
      for (std::size_t k = nodes.size(); k > 0; --k) open.push_back({nodes[k - 1], at});
    };
    push(roots(), Eigen::Affine3d::Identity());
    std::map<std::size_t, bool> seen;
    while (!open.empty()) {
      const Node next = open.back();
      open.pop_back();
      const Json& node = gltf_.at("nodes", next.index, "a scene or node");
      if (std::exchange(seen[next.index], true))
        throw MeshError(fmt::format("nodes[{}] is in two places; export it again", next.index));
      const Eigen::Affine3d placed = next.parent * placing_of(node);
      if (const auto mesh = whole_member(node, "mesh")) add_mesh(node, *mesh, placed);
      push(indices_in(node, "children"), placed);
    }
  }

  void add_mesh(const Json& node, std::size_t index, const Eigen::Affine3d& placed) {
    const Json& mesh = gltf_.at("meshes", index, "a node");
    std::string name = text_member(mesh, "name");
    if (name.empty()) name = text_member(node, "name");
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array()) return;
    for (std::size_t k = 0; k < primitives->size(); ++k)
      add_primitive((*primitives)[k], name, fmt::format("meshes[{}].primitives[{}]", index, k),
                    placed);
  }

  void add_primitive(const Json& primitive, const std::string& name, const std::string& place,
                     const Eigen::Affine3d& placed) {
    constexpr std::size_t kFirstOfFaces = 4, kLast = 6;
    const Json* attributes = object_member(&primitive, "attributes");
    if (attributes == nullptr) throw MeshError(place + " has no attributes; export it again");
    const std::size_t mode = whole_member(primitive, "mode").value_or(kFirstOfFaces);
    if (mode < kFirstOfFaces || mode > kLast || !attributes->contains("POSITION")) return;
    if (mesh_.parts.size() == kMostParts) throw MeshError("too many parts; simplify the model");
    const auto part = static_cast<std::uint32_t>(mesh_.parts.size());
    const std::optional<GltfPaint> paint = paint_of(primitive, place, part);
    mesh_.parts.push_back({name, paint ? paint->name : ""});
    const Attributes numbers = numbers_of(*attributes, paint, place);
    const std::vector<Corners> triangles =
        triangles_of(corners_of(primitive, numbers.positions.count, place), mode);
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (std::size_t k = 0; k < numbers.positions.count; ++k)
      add_vertex(mesh_, placed * Vector3d(numbers.positions.at(k, 0), numbers.positions.at(k, 1),
                                          numbers.positions.at(k, 2)));
    add_triangles(triangles, numbers, first, paint, part);
  }

  // Nothing where the primitive has no material; one that is not there is told.
  std::optional<GltfPaint> paint_of(const Json& primitive, const std::string& place,
                                    std::uint32_t part) {
    const std::optional<std::size_t> index = whole_member(primitive, "material");
    if (!index) return std::nullopt;
    if (const Json* material = gltf_.find("materials", *index)) return gltf_paint(gltf_, *material);
    add_missing(fmt::format("materials[{}], which {} names, is not there", *index, place), part);
    GltfPaint lost;
    lost.lost = true;
    return lost;
  }

  Attributes numbers_of(const Json& attributes, const std::optional<GltfPaint>& paint,
                        const std::string& place) {
    const auto read = [&](const std::string& key, std::size_t least_width) {
      const std::optional<std::size_t> index = whole_member(attributes, key.c_str());
      if (!index) return std::optional<GltfNumbers>();
      const std::string what = fmt::format("{} of {}", key, place);
      GltfNumbers numbers = read_accessor(gltf_, *index, what, ColouredMesh::kMaxVertices);
      if (numbers.width < least_width)
        throw MeshError(what + " has too few numbers; export it again");
      return std::optional(std::move(numbers));
    };
    Attributes numbers{*read("POSITION", 3), read("COLOR_0", 3), {}};
    if (paint && paint->picture)
      numbers.uv = read(fmt::format("TEXCOORD_{}", paint->picture->uv_set), 2);
    for (const auto* other : {&numbers.colours, &numbers.uv})
      if (*other && (*other)->count != numbers.positions.count)
        throw MeshError(place + " has attributes of different lengths; export it again");
    return numbers;
  }

  std::vector<std::uint32_t> corners_of(const Json& primitive, std::size_t vertices,
                                        const std::string& place) {
    std::vector<std::uint32_t> corners;
    if (const auto index = whole_member(primitive, "indices")) {
      const GltfNumbers numbers =
          read_accessor(gltf_, *index, "indices of " + place, 3 * ColouredMesh::kMaxTriangles);
      for (const double corner : numbers.values) {
        if (!(corner >= 0 && corner < static_cast<double>(vertices)))
          throw MeshError(fmt::format("{} has vertex {:g}, but there are {}; export it again",
                                      place, corner, vertices));
        corners.push_back(static_cast<std::uint32_t>(corner));
      }
    } else {
      for (std::size_t k = 0; k < vertices; ++k) corners.push_back(static_cast<std::uint32_t>(k));
    }
    return corners;
  }

  void add_triangles(const std::vector<Corners>& triangles, const Attributes& numbers,
                     std::uint32_t first, const std::optional<GltfPaint>& paint,
                     std::uint32_t part) {
    TexturedFaces::Picture* picture =
        paint && paint->picture ? picture_of(*paint->picture, numbers.uv.has_value(), part)
                                : nullptr;
    const bool lost = paint && (paint->lost || (paint->picture && picture == nullptr));
    faces_ += triangles.size();
    if (!paint && !numbers.colours) uncoloured_ += triangles.size();
    for (const Corners& corners : triangles) {
      Vector3d factor = paint ? paint->factor : Vector3d::Ones();
      if (numbers.colours) factor = factor.cwiseProduct(mean_colour(*numbers.colours, corners));
      if (picture != nullptr) {
        add_textured(*picture, corners, first, *numbers.uv, *paint->picture, factor, part);
        continue;
      }
      const Vector3d colour = lost                       ? stand_in_
                              : paint || numbers.colours ? srgb_of_linear(factor)
                                                         : kUncoloured;
      add_face(mesh_, Corners{first + corners[0], first + corners[1], first + corners[2]},
               colour.unaryExpr(&rounded), part);
    }
  }

  static Vector3d mean_colour(const GltfNumbers& colours, const Corners& corners) {
    Vector3d mean = Vector3d::Zero();
    for (const std::uint32_t corner : corners)
      mean += Vector3d(colours.at(corner, 0), colours.at(corner, 1), colours.at(corner, 2)) / 3;
    return mean;
  }

  void add_textured(TexturedFaces::Picture& picture, const Corners& corners, std::uint32_t first,
                    const GltfNumbers& uv, const GltfPicture& how, const Vector3d& factor,
                    std::uint32_t part) {
    std::array<Vector3d, 3> places;
    std::array<Vector2d, 3> coordinates;
    for (std::size_t k = 0; k < 3; ++k) {
      places[k] = mesh_.vertices[first + corners[k]];
      const Vector2d moved =
          how.uv_from_file * Vector2d(uv.at(corners[k], 0), uv.at(corners[k], 1));
      coordinates[k] = {moved.x(), 1 - moved.y()};  // the format's v points downwards
    }
    TexturedFaces::add(picture, places, coordinates, {factor, true}, part);
  }

  // Null where it is not there: that is told.
  TexturedFaces::Picture* picture_of(const GltfPicture& wanted, bool has_uv, std::uint32_t part) {
    if (!wanted.image) {
      add_missing(fmt::format("{} {}", wanted.place, wanted.fault), part);
      return nullptr;
    }
    const std::string image = fmt::format("images[{}]", *wanted.image);
    const std::string key = fmt::format("{} {} {}", image, static_cast<int>(wanted.wrap_u),
                                        static_cast<int>(wanted.wrap_v));
    TexturedFaces::Picture& picture =
        textured_.picture(key, [&] { return gltf_image(gltf_, *wanted.image); });
    if (!picture.texture) {
      add_missing(fmt::format("{} {}", image, picture.fault), part);
      return nullptr;
    }
    if (!has_uv) {
      add_missing(fmt::format("{} is on faces without TEXCOORD_{}", wanted.place, wanted.uv_set),
                  part);
      return nullptr;
    }
    picture.texture->wrap_u = wanted.wrap_u;
    picture.texture->wrap_v = wanted.wrap_v;
    return &picture;
  }

  // What several parts lack is told once.
  void add_missing(const std::string& what, std::uint32_t part) {
    const auto [told, added] = told_.try_emplace(what, mesh_.missing.size());
    if (added)
      mesh_.missing.push_back({{}, 0, what, "export it again with its materials and pictures", {}});
    mesh_.missing[told->second].parts.push_back(part);
  }

  GltfFile gltf_;
  const Vector3d stand_in_;
  ColouredMesh mesh_;
  TexturedFaces textured_;
  std::map<std::string, std::size_t> told_;  // places in mesh_.missing
  std::size_t faces_ = 0, uncoloured_ = 0;
};

}  // namespace

ColouredMesh parse_gltf(std::string_view bytes, const std::filesystem::path& file,
                        const Vector3d& stand_in) {
  return GltfReader(bytes, file, stand_in).read();
}

}  // namespace aspect
