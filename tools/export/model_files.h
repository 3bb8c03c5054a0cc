// What a model's files hold, as values of their formats. Partition and class k + 1 are cluster k of
// the model and class k of the index.
//
// Beyond the thesis a cluster has views on the edges of patches as well, found where the borders
// between aspects were bisected. They are views like any other here: in .vert, and
// in .det, .attr and .class, which would not agree with the index otherwise.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compiler/stored_model.h"
#include "tools/export/formats/attribute_file.h"
#include "tools/export/formats/class_file.h"
#include "tools/export/formats/detail_file.h"
#include "tools/export/formats/partition_file.h"

namespace aspect {

// By view: of its external contours.
using ViewAttributes = std::vector<std::vector<AttributeVector>>;

// By view.
std::vector<std::string> view_names_of(const StoredModel& model);

// Ids count views from 1.
std::vector<ListedVertex> vertices_of(const StoredModel& model);
std::vector<Partition> partitions_of(const StoredModel& model);

// Contours by the names that they have in the cluster.
std::vector<DetailGroup> details_of(const StoredModel& model, std::span<const std::string> names,
                                    const ViewAttributes& attributes);

// The contour types as the files have them: the mean of the attributes of all contours of a type.
// The k-means itself works with other attributes (feature.h), so that no program that only knows
// the means will find every contour's type again. A type that no contour is nearest to has the
// attributes of the nearest one.
std::vector<AttributeVector> means_of(const StoredModel& model, const ViewAttributes& attributes);

// Counts graphs, whatever the scoring.
std::vector<ListedClass> classes_of(const StoredModel& model);

}  // namespace aspect
