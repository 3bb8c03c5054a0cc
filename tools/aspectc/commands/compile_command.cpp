#include "tools/aspectc/commands/compile_command.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <atomic>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "compiler/compile.h"
#include "compiler/index/bundle_writer.h"
#include "tools/aspectc/commands/command_failure.h"
#include "tools/aspectc/commands/compile_outputs.h"
#include "tools/aspectc/commands/planned_index.h"
#include "tools/aspectc/commands/statistics_json.h"
#include "tools/aspectc/commands/whole_file.h"
#include "tools/aspectc/progress/progress_line.h"
#include "tools/aspectc/progress/stop_signals.h"
#include "tools/aspectc/project/distance_check.h"
#include "tools/aspectc/project/prepared_object.h"
#include "tools/aspectc/record/compile_record.h"
#include "tools/aspectc/record/content_hash.h"
#include "tools/command_line/command_line.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

struct PreparedPart {
  PreparedObject object;
  ObjectFiles files;
  std::vector<std::string> warnings;
  std::optional<RecordedObject> record;
};

struct PreparedIndex {
  fs::path output;
  bool is_bundle = false;
  std::string program;  // which compiles it
  std::vector<PreparedPart> parts;
};

std::vector<std::string> warnings_of(const PreparedObject& object) {
  std::vector<std::string> warnings = object.scene.warnings;
  for (const MissingColour& missing : object.scene.missing_colours)
    warnings.push_back(line_of(missing) + "; --missing-colour stands for it");
  if (const auto& distance = object.settings.camera.distance) {
    const auto more = distance_warnings(object.scene, object.settings.options.vision,
                                        distance->front(), distance->back());
    warnings.insert(warnings.end(), more.begin(), more.end());
  }
  return warnings;
}

// What was said of it when it was made is said again.
void print_unchanged(const PlannedIndex& index, const CompileRecord& record) {
  std::set<std::string> files;
  for (const RecordedObject& object : record.objects) {
    for (const std::string& warning : object.warnings) print_warning("aspectc", warning);
    for (const RecordedFile& file : object.inputs)
      if (!file.hash.starts_with(kAbsent)) files.insert(file.name);
  }
  fmt::print(
      "{}: is up to date, since {} and the options are as they were; --force compiles all "
      "the same\n",
      index.output.native(),
      files.size() == 1 ? *files.begin() : fmt::format("its {} files", files.size()));
}

Result<PreparedIndex> prepare_index(const PlannedIndex& planned, const RunStart& start) {
  PreparedIndex index{planned.output, planned.is_bundle, start.program, {}};
  for (const PlannedPart& part : planned.parts) {
    Result<PreparedObject> object = prepare_object(part.object);
    if (!object) return Error{object.error()};
    auto record = record_of(part, object.value(), planned.output, start);
    std::vector<std::string> warnings = warnings_of(object.value());
    index.parts.push_back({std::move(object).value(),
                           {planned.output, part.store},
                           std::move(warnings),
                           std::move(record)});
  }
  return index;
}

Result<CompiledIndex> compile_object(const PreparedObject& object, const ObjectFiles& files,
                                     const std::string& progress) {
  const std::map<std::string, ProgressMode> modes{{"auto", ProgressMode::automatic},
                                                  {"always", ProgressMode::always},
                                                  {"never", ProgressMode::never}};
  const CompileOptions& options = object.settings.options;
  ProgressLine line(object.scene.name, options.level, modes.at(progress));
  const std::atomic<bool>& stop =
      stop_on_signals("aspectc: " + interruption(files.store.has_value()).message);
  Result<CompiledIndex> compiled = compile(
      object.scene, options, files.store, [&](const Progress& p) { line.show(p); }, &stop);
  if (compiled.ok() && compiled.value().statistics.index.classes == 0)
    return Error{
        fmt::format("{}: not one class fits into {} KiB; raise --max-index-kib or lower "
                    "--types",
                    files.output.native(), options.max_index_bytes / 1024)};
  return compiled;
}

std::string no_golden_frame_reason(const CompileStatistics& s) {
  return s.sensor == SensorKind::range
             ? "a range index holds no golden frame"
             : "no golden frame, since no view was recognised without doubt in few enough bytes";
}

void warn_of_no_golden_frame(PreparedPart& part, const CompileStatistics& s) {
  if (s.index.golden_frame_bytes > 0) return;
  part.warnings.push_back(
      fmt::format("{}: {}; aspectd will test no more than its checksum when it starts",
                  part.files.output.native(), no_golden_frame_reason(s)));
  print_warning("aspectc", part.warnings.back());
}

void print_summary(const fs::path& file, const CompileStatistics& s) {
  fmt::print("{}: {} classes cover {:.1f} % of the sphere, {} views, {:.1f} KiB, {:.1f} s\n",
             file.native(), s.index.classes, 100 * s.index.area_assigned, s.subdivision.views,
             static_cast<double>(s.index.bytes) / 1024, s.seconds.total);
  if (s.index.classes < s.clusters.clusters)
    fmt::print(
        "{}: {} of {} classes, {:.1f} % of the sphere, did not fit in; --max-index-kib N "
        "keeps more\n",
        file.native(), s.clusters.clusters - s.index.classes, s.clusters.clusters,
        100 * (s.clusters.area_assigned - s.index.area_assigned));
}

Result<Done> write_statistics(const std::string& file, const std::vector<CompileStatistics>& all,
                              bool is_list) {
  if (file.empty()) return Done{};
  return write_whole_text(file, statistics_json(all, is_list));
}

// Without it the next run compiles again: no reason to fail after hours of work.
void keep_record(const PreparedIndex& index, const std::vector<std::uint8_t>& bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  CompileRecord record{index.program, content_hash(text), {}};
  for (const PreparedPart& part : index.parts) {
    if (!part.record) return;
    record.objects.push_back(*part.record);
    record.objects.back().warnings = part.warnings;
  }
  if (auto done = write_whole_text(record_file_of(index.output), record_text(record)); !done)
    print_warning("aspectc", done.error());
}

Result<std::vector<CompileStatistics>> compile_index(PreparedIndex& index,
                                                     const std::string& progress) {
  std::vector<CompileStatistics> statistics;
  std::vector<std::vector<std::uint8_t>> indexes;
  for (const PreparedPart& part : index.parts) {
    Result<CompiledIndex> compiled = compile_object(part.object, part.files, progress);
    if (!compiled) return Error{compiled.error()};
    statistics.push_back(compiled.value().statistics);
    indexes.push_back(std::move(compiled).value().bytes);
  }
  const std::vector<std::uint8_t> bytes =
      index.is_bundle ? write_bundle(indexes) : std::move(indexes.front());
  if (auto done = write_whole_file(index.output, bytes); !done) return Error{done.error()};
  for (std::size_t i = 0; i < statistics.size(); ++i)
    warn_of_no_golden_frame(index.parts[i], statistics[i]);
  keep_record(index, bytes);
  return statistics;
}

Result<Done> compile_all(std::vector<PreparedIndex>& indexes, const CompileCommand& command,
                         bool is_list) {
  std::vector<CompileStatistics> statistics;
  std::vector<fs::path> outputs;
  for (PreparedIndex& index : indexes) {
    const auto compiled = compile_index(index, command.progress);
    if (!compiled) return Error{compiled.error()};
    for (const CompileStatistics& one : compiled.value()) {
      statistics.push_back(one);
      outputs.push_back(index.output);
    }
  }
  if (auto done = write_statistics(command.statistics, statistics, is_list); !done) return done;
  for (std::size_t i = 0; i < statistics.size(); ++i) print_summary(outputs[i], statistics[i]);
  return Done{};
}

}  // namespace

void add_compile_options(CLI::App& app, CompileCommand& command) {
  app.add_option("scene", command.scene,
                 "Bob scene (.b) or mesh to compile, or a project that names some (.toml)")
      ->type_name("SCENE|FILE.toml");
  app.add_option("-o,--output", command.output,
                 "class index to write, or a folder where there are several [NAME.aspect, here]")
      ->type_name("FILE.aspect|FOLDER");
  app.add_option("--store", command.store,
                 "database of views and matches to resume from [NAME.store]")
      ->type_name("FILE.store");
  app.add_flag("--no-store", command.no_store,
               "keep no database; a run that is stopped starts anew");
  app.add_flag("--force", command.force,
               "compile even where inputs, options and index are as they were");
  app.add_option("--stats", command.statistics,
                 "write statistics to this JSON file; compiles in any case")
      ->type_name("FILE.json");
  take_words(app.add_option("--progress", command.progress,
                            "progress on standard error; auto: one line where it is a terminal"),
             {"auto", "always", "never"})
      ->capture_default_str();
  add_option_flags(app, command.flags);
}

int run_compile(const CompileCommand& command) {
  const RunStart start = start_run();
  const auto outcome = plan_objects(command.scene, command.flags);
  if (const auto* error = std::get_if<PreparationError>(&outcome))
    return error->usage ? refuse_usage(error->message) : fail(error->message);
  const auto& planned = std::get<PlannedObjects>(outcome);
  const CompileFiles files = name_files(planned, command);
  if (const auto fault = fault_of(files, planned, command)) return refuse_usage(*fault);
  const bool in_any_case = command.force || !command.statistics.empty();
  std::vector<PlannedIndex> changed;
  for (const PlannedIndex& index : planned_indexes(planned, files))
    if (const auto record = in_any_case ? std::nullopt : unchanged_record(index, start))
      print_unchanged(index, *record);
    else
      changed.push_back(index);
  if (changed.empty()) return 0;
  if (Result<Done> done = check_outputs(files, command); !done) return fail(done.error());
  std::vector<PreparedIndex> prepared;
  for (const PlannedIndex& index : changed) {
    Result<PreparedIndex> one = prepare_index(index, start);
    if (!one) return fail(one.error());
    prepared.push_back(std::move(one).value());
  }
  for (const PreparedIndex& index : prepared)
    for (const PreparedPart& part : index.parts)
      for (const std::string& warning : part.warnings) print_warning("aspectc", warning);
  const Result<Done> done = compile_all(prepared, command, planned.is_list);
  return done ? 0 : fail(done.error());
}

}  // namespace aspect
