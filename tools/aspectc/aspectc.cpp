// aspectc: compiles a scene into a class index, renders single views, prints indexes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <vector>

#include "compiler/compile.h"
#include "compiler/scene/bob_reader.h"
#include "runtime/recognition/class_match.h"
#include "tools/aspectc/explain_command.h"
#include "tools/aspectc/inspect_command.h"
#include "tools/aspectc/models_info_command.h"
#include "tools/aspectc/progress_line.h"
#include "tools/aspectc/project_file.h"
#include "tools/aspectc/render_command.h"
#include "tools/aspectc/statistics_json.h"
#include "tools/aspectc/stop_signals.h"
#include "tools/aspectc/whole_file.h"

namespace aspect {
namespace {

struct CompileCommand {
  std::string scene, output, store, statistics, progress = "auto", scoring = "views";
  bool no_store = false;
  std::size_t max_index_kib = 100;
  CompileOptions options;

  void add_to(CLI::App& app);
  int run();
  std::optional<std::filesystem::path> store_path() const;
  Result<Done> check_outputs() const;
  Result<CompiledIndex> compile_scene(const Scene& scene);
  Result<Done> write(const CompiledIndex& index) const;
};

void CompileCommand::add_to(CLI::App& app) {
  app.add_option("scene", scene, "Bob scene to compile (.b), or a project that names one (.toml)");
  app.add_option("-o,--output", output, "class index to write [NAME.aspect, here]");
  app.add_option("--level", options.level, "finest level of the viewing sphere's patches")
      ->check(CLI::Range(0, 10))
      ->capture_default_str();
  app.add_option("--min-level", options.min_level, "level up to which every patch is split")
      ->check(CLI::Range(0, 10))
      ->capture_default_str();
  app.add_option("--threshold", options.threshold,
                 "largest match cost between the views of a patch that is not split")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--cluster-threshold", options.cluster_threshold,
                 "the same when patches are clustered; at least --threshold")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--small-cluster", options.small_cluster_fraction,
                 "clusters that cover less of the sphere are discarded as noise")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  app.add_option("--types", options.contour_types, "contour types, K of the k-means")
      ->check(CLI::Range(std::size_t{1}, kMaxTypes))
      ->capture_default_str();
  app.add_option("--scoring", scoring, "score of a type: none, by views, or by their area")
      ->check(CLI::IsMember({"none", "views", "area"}))
      ->capture_default_str();
  app.add_option("--store", store, "database of views and matches to resume from [NAME.store]");
  app.add_flag("--no-store", no_store, "keep no database; a run that is stopped starts anew");
  app.add_option("--jobs", options.jobs, "threads [one a core]")->check(CLI::Range(1, 1024));
  app.add_option("--max-index-kib", max_index_kib, "largest size of the index")
      ->check(CLI::Range(1, 16384))
      ->capture_default_str();
  app.add_option("--stats", statistics, "write statistics to this JSON file");
  app.add_option("--progress", progress, "progress on stderr: auto, always, never")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
}

Result<CompiledIndex> CompileCommand::compile_scene(const Scene& loaded) {
  const std::map<std::string, ProgressMode> modes{{"auto", ProgressMode::automatic},
                                                  {"always", ProgressMode::always},
                                                  {"never", ProgressMode::never}};
  ProgressLine line(loaded.name, options.level, modes.at(progress));
  const std::atomic<bool>& stop =
      stop_on_signals("aspectc: " + interruption(store_path().has_value()).message);
  Result<CompiledIndex> compiled = compile(
      loaded, options, store_path(), [&](const Progress& p) { line.show(p); }, &stop);
  if (compiled.ok() && compiled.value().statistics.clusters_in_index == 0)
    return Error{
        fmt::format("{}: not one class fits into {} KiB; raise --max-index-kib or lower "
                    "--types",
                    output, max_index_kib)};
  return compiled;
}

std::optional<std::filesystem::path> CompileCommand::store_path() const {
  if (no_store) return std::nullopt;
  if (!store.empty()) return store;
  return std::filesystem::path(output).replace_extension(".store");
}

Result<Done> CompileCommand::check_outputs() const {
  if (Result<Done> done = check_writable(output); !done) return done;
  return statistics.empty() ? Done{} : check_writable(statistics);
}

Result<Done> CompileCommand::write(const CompiledIndex& index) const {
  if (Result<Done> done = write_whole_file(output, index.bytes); !done) return done;
  if (statistics.empty()) return Done{};
  const std::string json = statistics_json(index.statistics);
  const auto* first = reinterpret_cast<const std::uint8_t*>(json.data());
  return write_whole_file(statistics, {first, json.size()});
}

// Of two names for one file, there already or not.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code unknown;
  return std::filesystem::equivalent(a, b, unknown) ||
         std::filesystem::weakly_canonical(a, unknown) ==
             std::filesystem::weakly_canonical(b, unknown);
}

// No file may be two of scene, index, store and statistics. The name that is given twice, or none.
std::optional<std::string> file_given_twice(const std::vector<std::filesystem::path>& files) {
  for (std::size_t i = 0; i < files.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (is_same_file(files[i], files[k])) return files[k].string();
  return std::nullopt;
}

int fail(const std::string& message) {
  fmt::print(stderr, "aspectc: {}\n", message);
  return 1;
}

int CompileCommand::run() {
  if (options.cluster_threshold < options.threshold) {
    fmt::print(stderr, "aspectc: --cluster-threshold {} is below --threshold {}; raise it\n",
               options.cluster_threshold, options.threshold);
    return 2;
  }
  options.min_level = std::min(options.min_level, options.level);
  options.max_index_bytes = max_index_kib * 1024;
  options.scoring = scoring == "none"    ? Scoring::none
                    : scoring == "views" ? Scoring::views
                                         : Scoring::area;
  if (std::filesystem::path(scene).extension() == ".toml") {
    const Result<Project> project = read_project(scene);
    if (!project) return fail(project.error());
    scene = project.value().scene.string();
    options.vision = project.value().vision;
  }
  const Result<Scene> loaded = read_bob(scene);
  if (!loaded) return fail(loaded.error());
  for (const std::string& warning : loaded.value().warnings)
    fmt::print(stderr, "aspectc: warning: {}\n", warning);
  if (output.empty()) output = loaded.value().name + ".aspect";
  std::vector<std::filesystem::path> files = {scene, output};
  if (const auto path = store_path()) files.push_back(*path);
  if (!statistics.empty()) files.emplace_back(statistics);
  if (const auto twice = file_given_twice(files)) {
    fmt::print(stderr,
               "aspectc: {} is given twice; scene, index, store and statistics need a file each\n",
               *twice);
    return 2;
  }
  if (Result<Done> done = check_outputs(); !done) return fail(done.error());
  const Result<CompiledIndex> compiled = compile_scene(loaded.value());
  if (!compiled) return fail(compiled.error());
  if (Result<Done> done = write(compiled.value()); !done) return fail(done.error());
  const CompileStatistics& s = compiled.value().statistics;
  fmt::print("{}: {} classes cover {:.1f} % of the sphere, {} views, {:.1f} KiB, {:.1f} s\n",
             output, s.clusters_in_index, 100 * s.area_fraction_in_index, s.views,
             static_cast<double>(s.index_bytes) / 1024, s.seconds.total);
  return 0;
}

int run_program(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error like a full disk
  CLI::App app{"aspectc compiles a coloured CAD model into a class index for aspectd.", "aspectc"};
  app.set_version_flag("--version", ASPECT_VERSION);
  app.footer(
      "Examples:\n  aspectc part.b -o part.aspect --level 5\n"
      "  aspectc render part.b --from 1,0.5,0.3 --segmented -o view.png\n"
      "  aspectc inspect part.aspect\n  aspectc inspect part.store");
  CompileCommand compile_command;
  compile_command.add_to(app);
  RenderCommand render_command;
  CLI::App* render = add_render_command(app, render_command);
  InspectCommand inspect_command;
  CLI::App* inspect = add_inspect_command(app, inspect_command);
  ExplainCommand explain_command;
  CLI::App* explain = add_explain_command(app, explain_command);
  ModelsInfoCommand models_info_command;
  CLI::App* models_info = add_models_info_command(app, models_info_command);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (render->parsed()) return run_render(render_command);
  if (inspect->parsed()) return run_inspect(inspect_command);
  if (explain->parsed()) return run_explain(explain_command);
  if (models_info->parsed()) return run_models_info(models_info_command);
  if (compile_command.scene.empty()) {
    fmt::print(stderr, "aspectc: no scene given; aspectc --help shows how\n");
    return 2;
  }
  return compile_command.run();
}

}  // namespace
}  // namespace aspect

int main(int argc, char** argv) {
  try {
    return aspect::run_program(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "aspectc: %s\n", error.what());
    return 1;
  }
}
