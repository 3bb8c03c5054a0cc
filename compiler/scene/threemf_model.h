// One model part of a 3MF archive as it stands there.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aspect {

// <basematerials>, <m:colorgroup>; others, such as textures, are empty.
struct ThreeMfProperties {
  std::string kind;
  std::vector<std::string> names;        // of materials
  std::vector<Eigen::Vector3d> colours;  // as displayed
};

struct ThreeMfTriangle {
  std::array<std::uint32_t, 3> corners{};
  std::optional<std::uint32_t> properties;            // id of a group
  std::array<std::optional<std::uint32_t>, 3> place;  // in it, by corner
};

// An object in a place: a component of another, or an item of the build.
struct ThreeMfInstance {
  std::uint32_t object = 0;
  std::string part;  // of the archive, where the object is; empty: this one
  Eigen::Affine3d placed = Eigen::Affine3d::Identity();
};

struct ThreeMfObject {
  std::string name;
  bool is_model = true;  // and no support or mere surface
  std::vector<Eigen::Vector3d> vertices;
  std::vector<ThreeMfTriangle> triangles;
  std::vector<ThreeMfInstance> components;
  std::optional<std::uint32_t> properties, place;  // of triangles without
};

struct ThreeMfModel {
  double millimetres = 1;  // of a unit
  std::map<std::uint32_t, ThreeMfProperties> properties;
  std::map<std::uint32_t, ThreeMfObject> objects;
  std::vector<ThreeMfInstance> items;
};

// `part` names it in messages. Throws MeshError with the line within the part.
ThreeMfModel parse_threemf_model(std::string_view xml, const std::string& part);

// Of the relationships of an archive: the part that holds the model; empty where none does.
std::string root_model_of(std::string_view relationships);

}  // namespace aspect
