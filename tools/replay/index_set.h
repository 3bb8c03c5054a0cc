// The class indexes of one run.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "runtime/recognition/class_index.h"
#include "tools/replay/console.h"

namespace aspect {

// Those that can be used, of files with one index or with several. Each of the others is one
// failure on the console: unreadable, given twice, with the name of an object that is already
// there, or of another sensor than the first. A warning where one was compiled with another
// segmentation than the first.
std::vector<ClassIndex> load_indexes(std::span<const std::filesystem::path> files,
                                     Console& console);

}  // namespace aspect
