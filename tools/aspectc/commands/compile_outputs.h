// Which files a compilation reads and writes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compiler/store/done.h"
#include "tools/aspectc/commands/compile_command.h"
#include "tools/aspectc/project/prepared_object.h"

namespace aspect {

struct ObjectFiles {
  std::filesystem::path output;  // the same for all objects that are combined
  std::optional<std::filesystem::path> store;
};

struct CompileFiles {
  std::vector<ObjectFiles> objects;
};

// One index an object, NAME.aspect here or in the folder given; a combined one takes its name from
// the project. Stores lie beside them, one an object.
CompileFiles name_files(const PlannedObjects& planned, const CompileCommand& command);

// What is wrong with how the files were named, if anything: no file may be two of scene, index,
// store and statistics.
std::optional<std::string> fault_of(const CompileFiles& files, const PlannedObjects& planned,
                                    const CompileCommand& command);

// Before hours of work.
Result<Done> check_outputs(const CompileFiles& files, const CompileCommand& command);

}  // namespace aspect
