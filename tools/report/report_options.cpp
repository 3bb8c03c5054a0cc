#include "tools/report/report_options.h"

#include <CLI/CLI.hpp>

#include "tools/command_line/command_line.h"
#include "tools/command_line/terminal_colour.h"

namespace aspect {
namespace {

constexpr const char* kDescription =
    "Shows a compiled model on one HTML page: the object and its viewing sphere to turn by hand, "
    "every aspect with its views, contours, graph and neighbours, how much of the sphere is "
    "covered, and what aspectc explain says. Or all frames of a replay: what was seen in each, and "
    "why.";

constexpr const char* kFooter = R"(
The page is one file that any browser shows, without a network. The views are made again from the
store, and the pictures rendered again from its scene; the store stays as it is. The views that the
model is tried on, and the cure, are those of aspectc explain with the same options. The same store
and options give the same page.

Of lines of aspect-replay (.ndjson, .jsonl) the page has what aspect-replay --html would write, as
far as the lines know it: with --explain they know why, contours are not in them. Pictures are
looked for where the lines name them, then from the lines' own folder; where one is gone that is
said. With --index models are drawn.

Figures in --figures, each an SVG file of its own: object, sphere (the thesis's six projections),
sphere_patches, sphere_tried_views, coverage, areas, confusions, and aspect_000 and so on.

Exit code: 0 done, 1 a file was no good (one line on standard error), 2 wrong usage.

Examples:
  aspect-report part.store
  aspect-report part.store -o report.html --figures figures
  aspect-report found.ndjson --index part.aspect --truth truth.csv)";

struct RawOptions {
  ReportOptions options;
  std::string input, output, figures, scene, configuration, truth, symmetries;
  std::vector<std::string> indexes;
};

void add_line_options(CLI::App& app, RawOptions& raw) {
  app.add_option("--index", raw.indexes, "of lines: index of an object in them; repeat it for more")
      ->type_name("FILE.aspect")
      ->allow_extra_args(false)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_option("--config", raw.configuration,
                 "of lines: [camera] in TOML, as it was given to aspect-replay")
      ->type_name("FILE.toml");
  CLI::Option* truth =
      app.add_option("--truth", raw.truth, "of lines: what is right, as aspect-score takes it")
          ->type_name("FILE.csv");
  app.add_option("--symmetries", raw.symmetries,
                 "with --truth: rotations that leave objects as they are")
      ->needs(truth)
      ->type_name("FILE");
}

void add_options(CLI::App& app, RawOptions& raw) {
  ExplainSettings& trials = raw.options.settings.trials;
  app.add_option("input", raw.input, "store of a finished compilation, or lines of aspect-replay")
      ->required()
      ->type_name("FILE.store|FILE.ndjson");
  app.add_option("-o,--output", raw.output, "page to write [the input's name with .html]")
      ->type_name("FILE.html");
  app.add_option("--figures", raw.figures, "write every figure as SVG to this folder as well")
      ->type_name("FOLDER");
  app.add_option("--scene", raw.scene, "scene, where the store's cannot be read again")
      ->type_name("SCENE|FILE.toml");
  app.add_option("--views", trials.views, "random views that the model is tried on, 1 to 1000000")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000).description(""))
      ->capture_default_str();
  app.add_option("--seed", trials.seed, "of these views")->type_name("N")->capture_default_str();
  app.add_option("--cure-level", trials.cure_level,
                 "level at which changed colours are tried; at most the store's, 0 to 10")
      ->type_name("N")
      ->check(CLI::Range(0, 10).description(""))
      ->capture_default_str();
  app.add_option("--jobs", trials.jobs, "threads, 1 to 1024 [one a core]; changes no result")
      ->type_name("N")
      ->check(CLI::Range(1, 1024).description(""));
}

}  // namespace

std::variant<ReportOptions, int> parse_report_options(int argc, const char* const* argv) {
  CLI::App app(kDescription, "aspect-report");
  app.footer(kFooter);
  app.set_version_flag("--version", "aspect-report " ASPECT_VERSION);
  RawOptions raw;
  add_options(app, raw);
  add_line_options(app, raw);
  if (const auto exit_code = parse_command_line(app, argc, argv)) return *exit_code;
  ReportOptions options = std::move(raw.options);
  options.input = raw.input;
  options.output = raw.output;
  options.figures = raw.figures;
  options.settings.scene = raw.scene;
  options.lines = {
      {raw.indexes.begin(), raw.indexes.end()}, raw.configuration, raw.truth, raw.symmetries};
  if (options.output.empty()) options.output = options.input.filename().replace_extension(".html");
  return options;
}

}  // namespace aspect
