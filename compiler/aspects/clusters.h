// From patches to aspects: clusters of patches whose views match (thesis 3.4.1), and consistent
// names for the contours of all views of a cluster (3.4.2).
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/aspects/subdivision.h"

namespace aspect {

struct ClusterView {
  VertexId vertex{};
  double weight = 0;  // share of the sphere that the view stands for
  // External contour of the view -> its name in the cluster.
  std::vector<std::uint8_t> names;
};

struct Cluster {
  std::vector<PatchId> patches;
  std::vector<ClusterView> views;  // corners of the patches, by vertex, then others
  double area_fraction = 0;        // of the sphere, in its patches
  double area_assigned = 0;        // and in pieces of patches on its border: see border_classes.h
  std::size_t contour_count = 0;
};

struct ClusterStatistics {
  std::size_t clusters = 0;
  double area_fraction = 0, area_assigned = 0;  // sums of theirs
};

ClusterStatistics statistics_of(const std::vector<Cluster>& clusters);

// Algorithm 3.1, with the cluster threshold for "uniform" and "match"; neighbouring patches match
// if they share a view, and otherwise, across mixed levels, if their nearest corners do. Clusters
// below small_cluster_fraction are left out. Largest first. Deterministic.
std::vector<Cluster> find_clusters(const Subdivision& subdivision, const CompileOptions& options);

// The same on a sphere of fewer levels, whose vertices are the subdivision's first.
std::vector<Cluster> find_clusters(const ViewSphere& sphere, const Subdivision& subdivision,
                                   const CompileOptions& options);

}  // namespace aspect
