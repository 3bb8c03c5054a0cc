#include "tools/aspectc/commands/compile_command.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <atomic>
#include <filesystem>
#include <map>
#include <optional>

#include "compiler/compile.h"
#include "compiler/index/bundle_writer.h"
#include "tools/aspectc/commands/command_failure.h"
#include "tools/aspectc/commands/compile_outputs.h"
#include "tools/aspectc/commands/statistics_json.h"
#include "tools/aspectc/commands/whole_file.h"
#include "tools/aspectc/progress/progress_line.h"
#include "tools/aspectc/progress/stop_signals.h"
#include "tools/aspectc/project/distance_check.h"
#include "tools/aspectc/project/prepared_object.h"
#include "tools/command_line/command_line.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

int refuse_usage(const std::string& message) {
  fail(message);
  return kUsageError;
}

void print_warnings(const PreparedObject& object) {
  std::vector<std::string> warnings = object.scene.warnings;
  if (const auto& distance = object.settings.camera.distance) {
    const auto more = distance_warnings(object.scene, object.settings.options.vision,
                                        distance->front(), distance->back());
    warnings.insert(warnings.end(), more.begin(), more.end());
  }
  for (const std::string& warning : warnings) fmt::print(stderr, "aspectc: warning: {}\n", warning);
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
  if (s.index.golden_frame_bytes == 0)
    fmt::print(stderr,
               "aspectc: warning: {}: {}; aspectd will test no more than its checksum when it "
               "starts\n",
               file.native(), no_golden_frame_reason(s));
}

Result<Done> write_statistics(const std::string& file, const std::vector<CompileStatistics>& all,
                              bool is_list) {
  if (file.empty()) return Done{};
  const std::string json = statistics_json(all, is_list);
  const auto* first = reinterpret_cast<const std::uint8_t*>(json.data());
  return write_whole_file(file, {first, json.size()});
}

Result<Done> compile_all(const PreparedObjects& prepared, const CompileFiles& files,
                         const CompileCommand& command) {
  std::vector<CompileStatistics> statistics;
  std::vector<std::vector<std::uint8_t>> indexes;
  for (std::size_t i = 0; i < prepared.objects.size(); ++i) {
    const ObjectFiles& own = files.objects[i];
    Result<CompiledIndex> compiled = compile_object(prepared.objects[i], own, command.progress);
    if (!compiled) return Error{compiled.error()};
    statistics.push_back(compiled.value().statistics);
    indexes.push_back(std::move(compiled).value().bytes);
    if (!prepared.combined)
      if (auto done = write_whole_file(own.output, indexes.back()); !done) return done;
  }
  if (prepared.combined)
    if (auto done = write_whole_file(files.objects.front().output, write_bundle(indexes)); !done)
      return done;
  if (auto done = write_statistics(command.statistics, statistics, prepared.is_list); !done)
    return done;
  for (std::size_t i = 0; i < statistics.size(); ++i)
    print_summary(files.objects[i].output, statistics[i]);
  return Done{};
}

}  // namespace

void add_compile_options(CLI::App& app, CompileCommand& command) {
  app.add_option("scene", command.scene,
                 "Bob scene (.b) or mesh to compile, or a project that names some (.toml)");
  app.add_option("-o,--output", command.output,
                 "class index to write, or a folder where there are several [NAME.aspect, here]");
  app.add_option("--store", command.store,
                 "database of views and matches to resume from [NAME.store]");
  app.add_flag("--no-store", command.no_store,
               "keep no database; a run that is stopped starts anew");
  app.add_option("--stats", command.statistics, "write statistics to this JSON file");
  app.add_option("--progress", command.progress, "progress on stderr: auto, always, never")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
  add_option_flags(app, command.flags);
}

int run_compile(const CompileCommand& command) {
  const auto outcome = prepare_objects(command.scene, command.flags);
  if (const auto* error = std::get_if<PreparationError>(&outcome))
    return error->usage ? refuse_usage(error->message) : fail(error->message);
  const auto& prepared = std::get<PreparedObjects>(outcome);
  const CompileFiles files = name_files(prepared, command);
  if (const auto fault = fault_of(files, prepared, command)) return refuse_usage(*fault);
  for (const PreparedObject& object : prepared.objects) print_warnings(object);
  if (Result<Done> done = check_outputs(files, command); !done) return fail(done.error());
  const Result<Done> done = compile_all(prepared, files, command);
  return done ? 0 : fail(done.error());
}

}  // namespace aspect
