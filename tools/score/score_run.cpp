#include "tools/score/score_run.h"

#include <fmt/format.h>

#include <cstdio>

#include "tools/command_line/terminal_colour.h"
#include "tools/replay/console.h"
#include "tools/score/score_json.h"
#include "tools/score/score_sheet.h"
#include "tools/score/score_text.h"

namespace aspect {
namespace {

void check_demands(const ScoreOptions& options, const Score& score, Console& console) {
  const std::string& name = options.results.native();
  for (const ScoredFrame& frame : score.frames)
    if (frame.line == nullptr)
      console.fail(fmt::format("{}: no line for the frame {}; replay all frames of {}", name,
                               frame.file, options.truth.native()));
  const auto at_least = [&](const std::optional<double>& least, double share, const char* what) {
    if (least && !(100 * share >= *least))
      console.fail(fmt::format("{}: {:.1f} % of the {}; at least {} % were demanded", name,
                               100 * share, what, *least));
  };
  at_least(options.min_right_percent, score.all.right_share(), "objects are named right");
  at_least(options.min_within20_percent, score.all.within_20, "views are within 20 degrees");
  // Without objects there is no median; what was demanded of them cannot hold.
  const double median_deg = score.all.objects == 0 ? kNotFound_deg : score.all.median_deg;
  if (options.max_median_deg && !(median_deg <= *options.max_median_deg))
    console.fail(
        fmt::format("{}: the median error of the views is {:.2f} degrees; at most {} were demanded",
                    name, median_deg, *options.max_median_deg));
}

}  // namespace

int run_score(const ScoreOptions& options) {
  constexpr int kFailed = 1;
  Console console("aspect-score");
  const auto truth = read_truth(options.truth);
  if (!truth) return console.fail(truth.error()), kFailed;
  const auto results = read_results(options.results);
  if (!results) return console.fail(results.error()), kFailed;
  KnownRotations rotations;
  if (options.symmetries) {
    auto known = KnownRotations::read(*options.symmetries);
    if (!known) return console.fail(known.error()), kFailed;
    rotations = std::move(known).value();
  }
  const Score score =
      score_results(truth.value(), options.truth.parent_path(), results.value(), rotations);
  if (options.json) {
    fmt::print("{}", score_json(score, options.table));
  } else {
    if (options.table) fmt::print("{}\n", score_table(score, shows_colours(stdout)));
    fmt::print("{}", score_summary(score));
  }
  if (std::fflush(stdout) != 0)
    console.fail("standard output: cannot be written; check where it goes");
  if (options.sheet)
    if (const auto error = write_score_sheet(score, *options.overlays, *options.sheet))
      console.fail(error->message);
  check_demands(options, score, console);
  return console.failures() == 0 ? 0 : kFailed;
}

}  // namespace aspect
