#include "tools/score/score_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "tools/command_line/command_line.h"
#include "tools/command_line/terminal_colour.h"
#include "tools/score/truth_table.h"

namespace aspect {
namespace {

constexpr const char* kDescription =
    "Scores the output of aspect-replay against the truth: how many objects are named right, and "
    "how far off their views are.";

constexpr const char* kFooter = R"(
TRUTH.csv has one row an object in a frame, with a first line that names the columns: file, object,
vx, vy, vz (unit vector from the object's centre to the camera, object coordinates), x, y, w, h (the
visible box) and visible (share of the object that is not covered; at least 0.65 counts). A frame
without objects has one row with an empty object. Other columns are left alone.

An object is right where an overlapping thing seen (IoU of the boxes at least 0.3) has it as its
first hypothesis. The error of a view is modulo the rotations in the symmetries file: rows
object,x,y,z,degrees in a .csv (no degrees: any angle), or in a .toml tables
[[symmetry]] object = "cube", axis = [0, 1, 0], degrees = 90. An object that is not found has an
error of 180 degrees.

Keys of --json; what there is nothing to tell of is null:
  objects           object, number, right_percent, median_deg, within_5_percent,
                    within_10_percent, within_20_percent, median_ms
  all               the same of all objects
  frames, missing   how many there are, and how many of them the results lack
  falsely_named     things named where they are not
  table             frame, missing, ms, objects: true, found, counts (in the figures above), right,
                    error_deg; only with --table

Exit code: 0 done and all that was demanded holds; 1 it does not, a frame of the truth is missing in
the results, or a file was no good (one line each on standard error); 2 wrong usage.

Examples:
  aspect-replay --index a.aspect frames/ > seen.ndjson
  aspect-score truth.csv seen.ndjson --table --min-right 95 --max-median 5
  aspect-replay --index a.aspect --overlay drawn frames/ > seen.ndjson
  aspect-score truth.csv seen.ndjson --sheet sheet.png --overlays drawn
)";

void add_demand(CLI::App& app, const std::string& name, std::optional<double>& value, double most,
                const std::string& help, const std::string& type) {
  // CLI11's own range check lets "nan" through.
  const auto fault_of = [most](const std::string& text) {
    const auto number = finite_number(text);
    if (number && *number >= 0 && *number <= most) return std::string();
    return fmt::format("{} is not a number from 0 to {}", text, most);
  };
  app.add_option_function<double>(
         name, [&value](double number) { value = number; }, help)
      ->check(fault_of)
      ->type_name(type);
}

void add_path(CLI::App& app, const std::string& name, std::optional<std::filesystem::path>& path,
              const std::string& help, const std::string& type) {
  app.add_option_function<std::string>(
         name, [&path](const std::string& text) { path = text; }, help)
      ->type_name(type);
}

void add_options(CLI::App& app, ScoreOptions& options) {
  app.add_option("truth", options.truth, "the truth, a row an object in a frame")
      ->required()
      ->type_name("TRUTH.csv");
  app.add_option("results", options.results, "what aspect-replay printed, a line a frame")
      ->required()
      ->type_name("RESULTS.ndjson");
  add_path(app, "--symmetries", options.symmetries, "rotations that leave objects as they are",
           "FILE.csv|FILE.toml");
  app.add_flag("--table", options.table, "print a line for each object in each frame too");
  app.add_flag("--json", options.json,
               "print one JSON object; with --table the frames one by one are in it");
  add_path(app, "--sheet", options.sheet, "write the overlays with captions as one picture",
           "OUT.png");
  add_path(app, "--overlays", options.overlays, "the folder given to aspect-replay --overlay",
           "FOLDER");
  add_demand(app, "--min-right", options.min_right_percent, 100,
             "fail where fewer objects are named right", "PERCENT");
  add_demand(app, "--max-median", options.max_median_deg, 180,
             "fail where the median error of the views is larger", "DEGREES");
  add_demand(app, "--min-within20", options.min_within20_percent, 100,
             "fail where fewer views are within 20 degrees", "PERCENT");
}

}  // namespace

std::variant<ScoreOptions, int> parse_score_options(int argc, const char* const* argv) {
  CLI::App app(kDescription, "aspect-score");
  app.footer(kFooter);
  app.set_version_flag("--version", "aspect-score " ASPECT_VERSION);
  ScoreOptions options;
  add_options(app, options);
  if (const auto exit_code = parse_command_line(app, argc, argv)) return *exit_code;
  if (options.sheet.has_value() != options.overlays.has_value()) {
    print_failure("aspect-score", "--sheet and --overlays belong together; give both");
    return kUsageError;
  }
  return options;
}

}  // namespace aspect
