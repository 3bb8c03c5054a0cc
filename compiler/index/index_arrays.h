// The flat arrays of an index: classes, their contours and key views, as they lie in the file.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/index/index_budget.h"
#include "compiler/index/index_contents.h"
#include "schema/class_index_generated.h"

namespace aspect {

struct IndexArrays {
  std::vector<schema::AspectClass> classes;
  std::vector<schema::ClassContour> contours;
  std::vector<schema::TypeScore> scores;
  std::vector<std::uint16_t> surfaces;
  std::vector<schema::KeyView> key_views;
  std::vector<schema::KeyContour> key_contours;
};

IndexArrays pack_arrays(const IndexContents& contents, const IndexSelection& selection);

}  // namespace aspect
