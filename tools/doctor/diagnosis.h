// All that is wrong with a model before time is spent on it.
#pragma once

#include <optional>

#include "compiler/scene/coloured_mesh.h"
#include "tools/aspectc/project/prepared_object.h"
#include "tools/doctor/finding.h"
#include "tools/doctor/placement_checks.h"

namespace aspect {

struct Diagnosis {
  std::string object;
  std::size_t primitives = 0;
  std::vector<Finding> findings;  // by group, in the order in which they are to be cured

  std::size_t count(Severity severity) const;
  bool is_healthy() const { return count(Severity::error) + count(Severity::warning) == 0; }
};

// Under the object's own camera, light and segmentation. A mesh file is judged by its own faces,
// and so read once more.
Result<Diagnosis> diagnose(const PreparedObject& object);

WorkingDistance working_distance(const PreparedObject& object);

// Whether the scene was read from a mesh file.
bool is_mesh(const PreparedObject& object);

}  // namespace aspect
