// So many colours that touch others like them that each pair on its own would say the same: of a
// mesh that was scanned, shaded or covered with pictures.
#pragma once

#include "tools/doctor/finding.h"
#include "tools/doctor/sight.h"

namespace aspect {

struct ColourCrowd {
  std::vector<bool> has;    // by colour group: it touches one that it cannot be told from
  std::size_t colours = 0;  // of which that is true
  std::size_t pairs = 0;    // that touch
  std::size_t enough = 0;   // so many colours show nearly all of the surface as it is
  double share = 0;         // of the surface that is seen, in colours of the crowd
  std::vector<FindingExample> touching;  // each pair, that with the longest border first

  // As many as can be read and mended one by one.
  static constexpr std::size_t kFewPairs = 5, kFewColours = 8;
  bool is_one() const { return pairs > kFewPairs && colours > kFewColours; }
  // No primitive is of a crowd that is none.
  bool has_primitive(const ColourGroups& groups, std::size_t primitive) const;
};

ColourCrowd find_crowd(const ColourGroups& groups, const Sight& sight,
                       const VisionParameters& vision);

// In place of all that would be said of its colours and pieces one by one. Meshes alone can be
// repainted.
Finding crowd_finding(const ColourCrowd& crowd, const ColourGroups& groups, bool is_mesh,
                      const std::string& file);

}  // namespace aspect
