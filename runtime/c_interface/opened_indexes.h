// What aspect_open() is given, as values.
#pragma once

#include <string>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/c_interface/aspect.h"
#include "runtime/recognition/class_index.h"
#include "runtime/recognition/recogniser.h"

namespace aspect {

struct OpenedIndexes {
  std::vector<ClassIndex> indexes;  // loaded, checked and tested
  RecogniserParameters parameters;
  std::vector<std::string> warnings;  // one line each
};

// The configurations are a file and a text, null where there is none; the text wins. Everything
// must be right: one source that is not is the error of all.
Result<OpenedIndexes> open_indexes(std::span<const aspect_source> sources,
                                   const char* configuration_file, const char* configuration);

}  // namespace aspect
