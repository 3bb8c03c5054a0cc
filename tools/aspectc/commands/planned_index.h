// One index file to be made, and whether it is there already as it would be made.
#pragma once

#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/aspectc/commands/compile_outputs.h"
#include "tools/aspectc/project/prepared_object.h"
#include "tools/aspectc/record/compile_record.h"

namespace aspect {

struct PlannedPart {
  ProjectObject object;
  std::optional<std::filesystem::path> store;
};

struct PlannedIndex {
  std::filesystem::path output;
  bool is_bundle = false;
  std::vector<PlannedPart> parts;  // one, but of a bundle
};

std::vector<PlannedIndex> planned_indexes(const PlannedObjects& planned, const CompileFiles& files);

// What is true before anything is read.
struct RunStart {
  std::timespec time{};
  std::string program;  // program_identity(), which libraries that are loaded later would change
};
RunStart start_run();

// The record beside the index, if the index, all that it was made from, the options and this
// program are what they were, and a store that is wanted is there.
std::optional<CompileRecord> unchanged_record(const PlannedIndex& index, const RunStart& start);

// The record of a part whose scene has just been read. Nothing where a file may have changed since
// the start: what it held while it was read is then not known.
std::optional<RecordedObject> record_of(const PlannedPart& part, const PreparedObject& prepared,
                                        const std::filesystem::path& index, const RunStart& start);

}  // namespace aspect
