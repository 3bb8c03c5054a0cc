#include "compiler/scene/threemf_mesh.h"

#include <fmt/format.h>

#include <map>

#include "compiler/scene/mesh_text.h"
#include "compiler/scene/threemf_model.h"
#include "compiler/scene/zip_file.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMaxPartBytes = std::size_t{1} << 30, kMaxInstances = 100'000;
constexpr int kMaxDepth = 32;

// Names of parts begin with a slash, those of files in the archive do not.
std::string file_of(const std::string& part) {
  return part.starts_with('/') ? part.substr(1) : part;
}

// Where a triangle's colour comes from: a part of the mesh.
struct Paint {
  std::string material;
  std::optional<Vector3d> colour;
  std::string lack;  // why there is none
};

class Assembly {
 public:
  Assembly(std::string_view archive, const Vector3d& stand_in)
      : archive_(archive), stand_in_(stand_in) {}

  ColouredMesh read() {
    std::string root;
    if (const auto relationships = read_from_zip(archive_, "_rels/.rels", kMaxPartBytes))
      root = root_model_of(*relationships);
    if (root.empty()) root = "3D/3dmodel.model";
    const ThreeMfModel& model = model_of(root);
    for (const ThreeMfInstance& item : model.items)
      add(item, root, Eigen::Affine3d(Eigen::Scaling(model.millimetres)), 0);
    if (model.items.empty()) throw MeshError("builds nothing; export it with its objects placed");
    return std::move(mesh_);
  }

 private:
  const ThreeMfModel& model_of(const std::string& part) {
    const std::string file = file_of(part);
    const auto known = models_.find(file);
    if (known != models_.end()) return known->second;
    const auto xml = read_from_zip(archive_, file, kMaxPartBytes);
    if (!xml) throw MeshError(fmt::format("holds no part {}; export it again", shown(file)));
    return models_.emplace(file, parse_threemf_model(*xml, shown(file))).first->second;
  }

  void add(const ThreeMfInstance& instance, const std::string& around,
           const Eigen::Affine3d& placed_around, int depth) {
    if (depth > kMaxDepth || ++instances_ > kMaxInstances)
      throw MeshError(fmt::format(
          "objects are nested more than {} deep, or more than {} of them are placed; flatten it",
          kMaxDepth, kMaxInstances));
    const std::string part = instance.part.empty() ? around : instance.part;
    const ThreeMfModel& model = model_of(part);
    const auto found = model.objects.find(instance.object);
    if (found == model.objects.end())
      throw MeshError(fmt::format("places object {}, which {} does not hold; export it again",
                                  instance.object, shown(file_of(part))));
    const ThreeMfObject& object = found->second;
    if (!object.is_model) return;
    const Eigen::Affine3d placed = placed_around * instance.placed;
    add_triangles(model, object, placed);
    for (const ThreeMfInstance& component : object.components)
      add(component, part, placed, depth + 1);
  }

  void add_triangles(const ThreeMfModel& model, const ThreeMfObject& object,
                     const Eigen::Affine3d& placed) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (const Vector3d& vertex : object.vertices) add_vertex(mesh_, placed * vertex);
    const bool mirrored = placed.linear().determinant() < 0;
    std::map<std::pair<std::string, std::string>, std::uint32_t> parts;  // by material and lack
    for (const ThreeMfTriangle& triangle : object.triangles) {
      const Paint paint = paint_of(model, object, triangle);
      const auto [part, is_new] = parts.try_emplace({paint.material, paint.lack},
                                                    static_cast<std::uint32_t>(mesh_.parts.size()));
      if (is_new) {
        mesh_.parts.push_back({object.name, paint.material});
        if (!paint.colour) note_missing(object, paint, part->second);
      }
      std::array<std::uint32_t, 3> corners = triangle.corners;
      for (std::uint32_t& corner : corners) {
        if (corner >= object.vertices.size())
          throw MeshError(
              fmt::format("a face of '{}' has vertex {}, but there are {}; export it again",
                          shown(object.name), corner, object.vertices.size()));
        corner += first;
      }
      if (mirrored) std::swap(corners[1], corners[2]);
      add_face(mesh_, corners, paint.colour.value_or(stand_in_), part->second);
    }
  }

  void note_missing(const ThreeMfObject& object, const Paint& paint, std::uint32_t part) {
    constexpr std::size_t kMostTold = 100;
    const std::string what = fmt::format("'{}' has faces {}", shown(object.name), paint.lack);
    for (MissingColour& known : mesh_.missing)
      if (known.what == what || mesh_.missing.size() >= kMostTold)
        return known.parts.push_back(part);
    mesh_.missing.push_back({{},
                             0,
                             what,
                             "colour them and export it with its colours, or give some under "
                             "[mesh] colours in a project",
                             {part}});
  }

  static Paint paint_of(const ThreeMfModel& model, const ThreeMfObject& object,
                        const ThreeMfTriangle& triangle) {
    // Without a p1 a triangle has its object's, whatever its pid.
    const bool own = triangle.place[0].has_value();
    const auto group = own && triangle.properties ? triangle.properties : object.properties;
    const auto place = own ? triangle.place[0] : object.place;
    if (!group || !place) return {"", std::nullopt, "without a colour"};
    const auto found = model.properties.find(*group);
    if (found == model.properties.end())
      return {"", std::nullopt, fmt::format("of group {}, which is not there", *group)};
    const ThreeMfProperties& properties = found->second;
    if (properties.kind != "basematerials" && properties.kind != "colorgroup")
      return {"", std::nullopt, fmt::format("with {}, which is not read", properties.kind)};
    Vector3d mean = Vector3d::Zero();
    for (const auto& of_corner : triangle.place) {
      const std::uint32_t at = own ? of_corner.value_or(*place) : *place;
      if (at >= properties.colours.size())
        return {"", std::nullopt,
                fmt::format("of place {} of group {}, which is not there", at, *group)};
      mean += properties.colours[at] / 3;
    }
    const bool is_material = *place < properties.names.size();
    return {is_material ? properties.names[*place] : "", mean, ""};
  }

  std::string_view archive_;
  const Vector3d stand_in_;
  std::map<std::string, ThreeMfModel> models_;  // by file
  std::size_t instances_ = 0;
  ColouredMesh mesh_;
};

}  // namespace

ColouredMesh parse_threemf(std::string_view archive, const Vector3d& stand_in) {
  return Assembly(archive, stand_in).read();
}

}  // namespace aspect
