// The class indexes of one run.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "runtime/recognition/class_index.h"

namespace aspect {

struct IndexSet {
  std::vector<ClassIndex> indexes;
  std::vector<std::filesystem::path> files;  // that each of them came from
  std::vector<std::string> failures;         // one line each: what could not be used, and why
  std::vector<std::string> warnings;         // one was compiled with another segmentation
};

// Those that can be used, of files with one index or with several. A file is no good that cannot be
// read or is given twice; an index, that is of an object that is already there, or of another
// sensor than the first.
IndexSet load_indexes(std::span<const std::filesystem::path> files);

// What `name` holds, on top of what is there.
void add_indexes(const std::filesystem::path& name, std::vector<ClassIndex> indexes, IndexSet& set);
// Of a file.
void load_indexes(const std::filesystem::path& file, IndexSet& set);

}  // namespace aspect
