// .means: the mean vectors of the contour types (thesis A.2.9): how many there are, and the ten
// attributes of each on a line, in whole numbers, as in .attr.
#pragma once

#include <string>
#include <vector>

#include "tools/export/formats/attribute_file.h"

namespace aspect {

std::string means_text(const std::vector<AttributeVector>& means);
Result<std::vector<AttributeVector>> parse_means(std::string_view text, std::string_view name);

}  // namespace aspect
