#include "tools/aspectc/commands/planned_index.h"

#include <algorithm>

#include "tools/aspectc/record/content_hash.h"
#include "tools/aspectc/record/program_identity.h"
#include "tools/aspectc/record/settings_text.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

RecordedObject planned_record(const PlannedPart& part, const fs::path& folder) {
  RecordedObject record;
  record.name = part.object.name;
  record.settings = settings_text(part.object.settings);
  record.scene = recorded_name(part.object.scene, folder);
  if (part.store) record.store = recorded_name(*part.store, folder);
  return record;
}

bool is_there(const fs::path& store) {
  std::error_code unknown;
  return fs::is_regular_file(store, unknown) && fs::file_size(store, unknown) > 0;
}

}  // namespace

std::vector<PlannedIndex> planned_indexes(const PlannedObjects& planned,
                                          const CompileFiles& files) {
  std::vector<PlannedIndex> indexes;
  for (std::size_t i = 0; i < planned.objects.size(); ++i) {
    const ObjectFiles& own = files.objects[i];
    if (i == 0 || !planned.combined) indexes.push_back({own.output, planned.combined, {}});
    indexes.back().parts.push_back({planned.objects[i], own.store});
  }
  return indexes;
}

RunStart start_run() {
  return {file_time_now(), program_identity()};
}

std::optional<CompileRecord> unchanged_record(const PlannedIndex& index, const RunStart& start) {
  const std::optional<CompileRecord> before = read_record(index.output);
  if (!before || before->objects.size() != index.parts.size()) return std::nullopt;
  const fs::path folder = folder_of(index.output);
  CompileRecord now{start.program, content_hash_of_file(index.output), {}};
  for (std::size_t i = 0; i < index.parts.size(); ++i) {
    const PlannedPart& part = index.parts[i];
    const RecordedObject& own_before = before->objects[i];
    RecordedObject& own = now.objects.emplace_back(planned_record(part, folder));
    if (part.store && !is_there(*part.store)) return std::nullopt;
    if (!part.store) own.store = own_before.store;
    own.inputs = files_now(own_before.inputs, folder);
    own.warnings = own_before.warnings;
  }
  return now == *before ? before : std::nullopt;
}

std::optional<RecordedObject> record_of(const PlannedPart& part, const PreparedObject& prepared,
                                        const fs::path& index, const RunStart& start) {
  RecordedObject record = planned_record(part, folder_of(index));
  record.inputs = recorded_files(prepared.scene.files, folder_of(index));
  const auto& files = prepared.scene.files;
  if (std::any_of(files.begin(), files.end(),
                  [&](const auto& file) { return has_changed_since(file, start.time); }))
    return std::nullopt;
  return record;
}

}  // namespace aspect
