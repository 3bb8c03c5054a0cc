// What the compiler has learnt of an object, ready to be written: classes described by contour
// types (thesis 3.4.4), and the key views kept of each.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "compiler/aspects/clusters.h"
#include "compiler/aspects/compile_options.h"

namespace aspect {

struct ContourDescription {
  std::map<std::uint16_t, double> score_of_type;
  std::array<double, 3> share{};  // mean over the views
  Eigen::Vector3d centre_object{0, 0, 0};
  std::vector<std::uint16_t> surfaces;
};

struct ClassDescription {
  std::vector<ContourDescription> contours;  // by name
  double area_fraction = 0;
  std::size_t view_count = 0;
  std::size_t typical_view = 0;  // index into the cluster's views
};

// Type attributes of all external contours of all views of all clusters: what the k-means sees.
std::vector<TypeAttributes> contour_samples(const Subdivision& subdivision,
                                            std::span<const Cluster> clusters);

ClassDescription describe_class(const Subdivision& subdivision, const Cluster& cluster,
                                std::span<const TypeAttributes> types, Scoring scoring);

// The contour types of all clusters, and each described by them.
struct DescribedClasses {
  std::vector<TypeAttributes> types;
  std::vector<ClassDescription> classes;  // one a cluster
};
DescribedClasses describe_classes(const Subdivision& subdivision, std::span<const Cluster> clusters,
                                  const CompileOptions& options);

// Views of a cluster so chosen that none is farther than `spacing_rad` from a chosen one, the
// typical view first, then always the farthest from those before: indices into cluster.views.
// O(views * chosen).
std::vector<std::size_t> choose_key_views(const Subdivision& subdivision, const Cluster& cluster,
                                          std::size_t typical_view, double spacing_rad);

}  // namespace aspect
