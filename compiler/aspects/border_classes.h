// Which aspect every part of the viewing sphere belongs to, patches that straddle a border
// included.
#pragma once

#include <vector>

#include "compiler/aspects/clusters.h"
#include "compiler/viewsphere/patch_division.h"

namespace aspect {

// Divides the patches that are in no cluster among the clusters that their corners and the views on
// their edges belong to: a view belongs where it matches a view of a cluster, the cheapest match
// first; views left over that match each other are clusters of their own, aspects too thin for a
// uniform patch, at the end and only if they come to small_cluster_fraction. Adds those views,
// named, to their clusters, and what a cluster gains to its area_assigned. Classes are the places
// of clusters. Where bisection ended early, what lies between views of different classes more than
// an eighth of an edge apart is of none. Without views on edges nothing is divided.
SphereClasses divide_borders(const Subdivision& subdivision, const CompileOptions& options,
                             std::vector<Cluster>& clusters);

}  // namespace aspect
