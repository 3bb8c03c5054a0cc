#include "tools/bench/bench_options.h"

#include <CLI/CLI.hpp>

#include "tools/command_line/command_line.h"

namespace aspect {
namespace {

constexpr const char* kNotes =
    R"(The options are Google Benchmark's, whose user guide tells more. Run from anywhere: what is measured
comes from the source folder that the program was built from.

Exit code: 0 done, 1 a file was no good or nothing was measured, 2 wrong usage.

Examples:
  aspect-bench --benchmark_filter=frame_to_graph
  aspect-bench --json > figures.json
  aspect-bench --plot costs.svg --from figures.json)";

// As benchmark::Initialize wants them: in one word.
void add(CLI::App& app, std::vector<std::string>& given, const std::string& name,
         const std::string& value, const std::string& meaning) {
  app.add_option_function<std::string>(
         name, [&given, name](const std::string& text) { given.push_back(name + "=" + text); },
         meaning)
      ->type_name(value);
}

// Also without a value: true.
void add_truth(CLI::App& app, std::vector<std::string>& given, const std::string& name,
               const std::string& meaning) {
  app.add_option_function<std::string>(
         name,
         [&given, name](const std::string& text) {
           given.push_back(name + "=" + (text.empty() ? "true" : text));
         },
         meaning)
      ->type_name("true|false")
      ->expected(0, 1);
}

void add_choice_of_work(CLI::App& app, std::vector<std::string>& given) {
  add(app, given, "--benchmark_filter", "REGEX", "run those alone whose names match [all]");
  add_truth(app, given, "--benchmark_list_tests", "print the names and end [false]");
  add(app, given, "--benchmark_min_time", "SECONDS", "least time of each [0.5]");
  add(app, given, "--benchmark_min_warmup_time", "SECONDS", "time before it counts [0]");
  add(app, given, "--benchmark_repetitions", "N", "runs of each [1]");
  add_truth(app, given, "--benchmark_enable_random_interleaving",
            "repetitions of all by turns, in random order [false]");
}

void add_output(CLI::App& app, std::vector<std::string>& given) {
  app.add_flag_function(
      "--json", [&given](std::int64_t) { given.emplace_back("--benchmark_format=json"); },
      "print one JSON object: --benchmark_format=json");
  add(app, given, "--benchmark_format", "console|json|csv", "what is printed [console]");
  add(app, given, "--benchmark_out", "FILE", "write the results to this file as well");
  add(app, given, "--benchmark_out_format", "console|json|csv", "and in this format [json]");
  add(app, given, "--benchmark_color", "auto|true|false", "colours in what is printed [auto]");
  add(app, given, "--benchmark_time_unit", "ns|us|ms|s", "of what has no unit of its own [ns]");
  add(app, given, "--benchmark_context", "KEY=VALUE,...", "print these with the machine's figures");
  add_truth(app, given, "--benchmark_counters_tabular", "counters in columns [false]");
  add_truth(app, given, "--benchmark_report_aggregates_only",
            "of repetitions only mean, median and deviation, everywhere [false]");
  add_truth(app, given, "--benchmark_display_aggregates_only",
            "the same, but not in the file [false]");
  add(app, given, "--v", "N", "how much it tells of its own work [0]");
}

}  // namespace

std::variant<BenchOptions, int> parse_bench_options(int argc, const char* const* argv) {
  CLI::App app("Measures how long the stages of compiling and seeing take.", "aspect-bench");
  app.footer(kNotes);
  app.set_version_flag("--version", "aspect-bench " ASPECT_VERSION);
  std::vector<std::string> given;
  std::string plot, from;
  add_choice_of_work(app, given);
  add_output(app, given);
  CLI::Option* plotted =
      app.add_option("--plot", plot,
                     "draw what was measured: a view's stages, the cost by level, and all else")
          ->type_name("FILE.svg");
  app.add_option("--from", from, "draw these results, of --benchmark_out; nothing is measured")
      ->type_name("FILE.json")
      ->needs(plotted);
  if (const auto exit_code = parse_command_line(app, argc, argv)) return *exit_code;
  return BenchOptions{std::move(given), plot, from};
}

}  // namespace aspect
