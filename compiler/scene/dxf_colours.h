// The colours of a DXF file's entities.
#pragma once

#include <map>
#include <string>

#include "compiler/scene/dxf_groups.h"

namespace aspect {

// What an entity inherits from the INSERT it is part of.
struct DxfOwner {
  Eigen::Vector3d colour{1, 1, 1};
  std::string layer = "0";
};

class DxfLayers {
 public:
  void add(const DxfRecord& layer);

  // An entity on layer 0 stands on its owner's.
  static std::string layer_of(const DxfRecord& entity, const DxfOwner& owner);
  Eigen::Vector3d colour_of(const DxfRecord& entity, const DxfOwner& owner) const;

 private:
  std::map<std::string, Eigen::Vector3d> colours_;
};

}  // namespace aspect
