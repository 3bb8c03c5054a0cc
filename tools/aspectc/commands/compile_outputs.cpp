#include "tools/aspectc/commands/compile_outputs.h"

#include <fmt/format.h>

#include "tools/aspectc/commands/whole_file.h"
#include "tools/aspectc/record/compile_record.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

// Of two names for one file, there already or not.
bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code unknown;
  return fs::equivalent(a, b, unknown) ||
         fs::weakly_canonical(a, unknown) == fs::weakly_canonical(b, unknown);
}

std::optional<fs::path> file_given_twice(const std::vector<fs::path>& files) {
  for (std::size_t i = 0; i < files.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (is_same_file(files[i], files[k])) return files[k];
  return std::nullopt;
}

// Each file once.
std::vector<fs::path> scenes_of(const PlannedObjects& planned) {
  std::vector<fs::path> scenes;
  for (const ProjectObject& object : planned.objects) {
    scenes.push_back(object.scene);
    if (file_given_twice(scenes)) scenes.pop_back();
  }
  return scenes;
}

bool is_one_file_each(const PlannedObjects& planned) {
  return planned.is_list && !planned.combined;
}

fs::path output_of(const PlannedObjects& planned, const ProjectObject& object,
                   const CompileCommand& command) {
  const std::string own_name = object.name + ".aspect";
  if (is_one_file_each(planned)) return fs::path(command.output) / own_name;
  if (!command.output.empty()) return command.output;
  return planned.combined ? fs::path(command.scene).stem().native() + ".aspect" : own_name;
}

}  // namespace

CompileFiles name_files(const PlannedObjects& planned, const CompileCommand& command) {
  CompileFiles files;
  for (const ProjectObject& object : planned.objects) {
    ObjectFiles own{output_of(planned, object, command), std::nullopt};
    if (!command.no_store && !command.store.empty())
      own.store = command.store;
    else if (!command.no_store && planned.is_list)
      own.store = own.output.parent_path() / (object.name + ".store");
    else if (!command.no_store)
      own.store = fs::path(own.output).replace_extension(".store");
    files.objects.push_back(std::move(own));
  }
  return files;
}

std::optional<std::string> fault_of(const CompileFiles& files, const PlannedObjects& planned,
                                    const CompileCommand& command) {
  if (files.objects.size() > 1 && !command.store.empty())
    return "--store names one store, and each object needs its own; leave it out";
  if (is_one_file_each(planned) && !command.output.empty() && !fs::is_directory(command.output))
    return fmt::format("{} is no folder, and each object gets its own index; give a folder",
                       command.output);
  // Two objects may be made of one scene, and a combined index is of all of them.
  std::vector<fs::path> all = scenes_of(planned);
  if (fs::path(command.scene).extension() == ".toml") all.emplace_back(command.scene);
  for (std::size_t i = 0; i < files.objects.size(); ++i) {
    if (i == 0 || !planned.combined) {
      all.push_back(files.objects[i].output);
      all.push_back(record_file_of(files.objects[i].output));
    }
    if (files.objects[i].store) all.push_back(*files.objects[i].store);
  }
  if (!command.statistics.empty()) all.emplace_back(command.statistics);
  if (const auto twice = file_given_twice(all))
    return fmt::format("{} is given twice; scene, index, store and statistics need a file each",
                       twice->native());
  return std::nullopt;
}

Result<Done> check_outputs(const CompileFiles& files, const CompileCommand& command) {
  for (const ObjectFiles& own : files.objects)
    if (Result<Done> done = check_writable(own.output); !done) return done;
  return command.statistics.empty() ? Done{} : check_writable(command.statistics);
}

}  // namespace aspect
