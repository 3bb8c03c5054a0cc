// The layers of a DXF file: whether their entities are drawn, and in which colours.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <string>

#include "compiler/scene/dxf_groups.h"

namespace aspect {

// Why an entity is not to be seen.
enum class DxfHiding : std::uint8_t { none, layer_off, layer_frozen, invisible, paper_space };

// What an entity inherits from the INSERT it is part of.
struct DxfOwner {
  Eigen::Vector3d colour{1, 1, 1};
  std::string layer = "0";
};

class DxfLayers {
 public:
  void add(const DxfRecord& layer);

  // An entity on layer 0 stands on its owner's. The name is the layer table's, whatever its case
  // where it is used.
  std::string layer_of(const DxfRecord& entity, const DxfOwner& owner) const;
  Eigen::Vector3d colour_of(const DxfRecord& entity, const DxfOwner& owner) const;

  // An INSERT on a layer that is off hides only what takes that layer from it; on one that is
  // frozen, all of its block (Autodesk's help on LAYER).
  DxfHiding hiding_of(const DxfRecord& entity, const DxfOwner& owner) const;

 private:
  struct Layer {
    std::string name;
    Eigen::Vector3d colour;
    bool off = false, frozen = false;
  };
  const Layer* find(const std::string& name) const;

  std::map<std::string, Layer> layers_;  // by dxf_key()
};

}  // namespace aspect
