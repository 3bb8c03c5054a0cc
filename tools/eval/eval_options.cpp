#include "tools/eval/eval_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "tools/command_line/command_line.h"
#include "tools/command_line/terminal_colour.h"

namespace aspect {
namespace {

constexpr const char* kDescription =
    "Repeats the thesis's experiments: renders objects from random viewpoints, recognises the "
    "pictures and tells how often the right aspect comes first, second and so on, how far the view "
    "and the pose are off, and how far the probability can be believed.";

constexpr const char* kFooter = R"(
The right class is the one whose views come nearest to the viewpoint. "With symmetry" a class also
counts as right where a proper rotation of the object, found in its scene, takes it to the right
one. The error of the view direction is that of the best hypothesis, modulo these rotations; 180
degrees where there is none. With several objects every picture is also recognised with all indexes
at once. The same options give the same views and the same results everywhere, but for the times.

The error of the pose is that of the best hypothesis as well: its turn in degrees modulo the same
rotations, the place of the object's centre in % of its distance, and the model's vertices in px
(root mean square). Medians and 90th percentiles are of the views with a pose; what is within 5 is a
share of all views.

A match is right where the best hypothesis names the object that is there. The expected calibration
error is how far the probability is from the share that is right: the mean over ten equal bins,
weighted by their views. With one object every name is right; give those that it is to be told from.

--clutter makes frames of another kind and measures how often an object is found in them: it stands
anywhere in the picture, turned at random, at once to 2.2 times the scene's distance, lit from a
side, before coloured shapes or pieces of pictures; two frames of three hide some of it; light,
tint, blur and noise are a camera's. One frame of four shows no object. --views is the number of
frames. Found is an object that is a match by its name, in a box that overlaps its own by 0.3 (IoU);
recall and errors are of the frames in which at least 65 % of it is visible, as aspect-score counts.
Any other match is falsely named. With several objects all indexes look for them at once. Of a
folder of more than 200 pictures 200 are used.

Exit code: 0 done, 1 a file was no good (one line on standard error), 2 wrong usage.

Examples:
  aspect-eval --index cube.aspect --scene cube.b
  aspect-eval --index a.aspect --scene a.b --index b.aspect --scene b.b --views 1000 --json
  aspect-eval --index two.aspect --scene a.b --scene b.b --reliability plot.svg
  aspect-eval --index two.aspect --scene a.b --scene b.b --plots plots
  aspect-eval --index cube.aspect --scene cube.b --clutter --backgrounds photos --hidden 0.3
)";

struct RawOptions {
  EvalOptions options;
  std::vector<std::string> indexes, scenes;
  std::string matching = "weighted", ranking = "views", reliability, backgrounds, dump, recall,
              plots, thesis;
};

void add_files(CLI::App& app, const std::string& name, std::vector<std::string>& files,
               const std::string& help, const std::string& type) {
  app.add_option(name, files, help)
      ->required()
      ->type_name(type)
      ->allow_extra_args(false)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_options(CLI::App& app, RawOptions& raw) {
  constexpr int kMostViews = 1'000'000;
  add_files(app, "--index", raw.indexes,
            "class index of an object or of several; repeat both for more", "FILE.aspect");
  add_files(app, "--scene", raw.scenes,
            "the scene or the project it was compiled from, in the same order; one for "
            "each object",
            "FILE.b|FILE.toml");
  app.add_option("--views", raw.options.views,
                 "random viewpoints for each object, or frames in clutter [100]")
      ->check(CLI::Range(1, kMostViews).description(""))
      ->type_name("N");
  app.add_option("--seed", raw.options.seed,
                 "of the viewpoints, the same for all objects, or of the frames [1]")
      ->check(CLI::Validator(CLI::NonNegativeNumber).description(""))
      ->type_name("N");
  take_words(app.add_option("--matching", raw.matching,
                            "match most contours, or of those the best scored [weighted]"),
             {"simple", "weighted"});
  take_words(
      app.add_option(
          "--ranking", raw.ranking,
          "order by the best key view, or by the class's score alone, as the thesis [views]"),
      {"views", "classes"});
  app.add_option("--reliability", raw.reliability,
                 "write a plot of the share of right answers against their probability; of all "
                 "indexes at once where there are several")
      ->type_name("FILE.svg");
  CLI::Option* plots =
      app.add_option("--plots", raw.plots,
                     "write plots to this folder: rank, pose_error, reliability and, of several "
                     "objects, confusion; in clutter recall and pose_error")
          ->type_name("FOLDER");
  app.add_option("--thesis-ranks", raw.thesis,
                 "draw the thesis's ranks beside ours: a table object,top1,top2,...")
      ->type_name("FILE.csv")
      ->needs(plots);
  app.add_flag("--json", raw.options.json, "print one JSON object with everything");
}

void add_clutter_options(CLI::App& app, RawOptions& raw) {
  CLI::Option* clutter =
      app.add_flag("--clutter", raw.options.clutter,
                   "measure recognition in clutter instead, on frames made for it; see below");
  app.add_option("--backgrounds", raw.backgrounds,
                 "put the objects before pieces of the pictures of this folder")
      ->type_name("FOLDER")
      ->needs(clutter);
  app.add_option("--hidden", raw.options.hidden_max,
                 "hide up to this share of an object, 0 to 0.7 [0.7]")
      ->check(CLI::Range(0.0, 0.7).description(""))
      ->type_name("SHARE")
      ->needs(clutter);
  app.add_option("--dump", raw.dump,
                 "write the frames as PNG files and their truth.csv to this folder")
      ->type_name("FOLDER")
      ->needs(clutter);
  app.add_option("--recall", raw.recall, "write a plot of the recall against the share hidden")
      ->type_name("FILE.svg")
      ->needs(clutter);
}

EvalOptions finished(RawOptions raw) {
  using Ranking = RecogniserParameters::Ranking;
  EvalOptions options = std::move(raw.options);
  options.indexes.assign(raw.indexes.begin(), raw.indexes.end());
  options.scenes.assign(raw.scenes.begin(), raw.scenes.end());
  options.matching = raw.matching == "simple" ? Matching::simple : Matching::weighted;
  options.ranking = raw.ranking == "views" ? Ranking::views : Ranking::classes;
  options.reliability = raw.reliability;
  options.backgrounds = raw.backgrounds;
  options.dump = raw.dump;
  options.recall = raw.recall;
  options.plots = raw.plots;
  options.thesis = raw.thesis;
  return options;
}

}  // namespace

std::string pairs_needed(std::size_t indexes, std::size_t scenes) {
  return fmt::format("{} --index but {} --scene; give them in pairs, see aspect-eval --help",
                     indexes, scenes);
}

std::variant<EvalOptions, int> parse_eval_options(int argc, const char* const* argv) {
  CLI::App app(kDescription, "aspect-eval");
  app.footer(kFooter);
  app.set_version_flag("--version", "aspect-eval " ASPECT_VERSION);
  RawOptions raw;
  add_options(app, raw);
  add_clutter_options(app, raw);
  if (const auto exit_code = parse_command_line(app, argc, argv)) return *exit_code;
  if (raw.indexes.size() > raw.scenes.size()) {
    print_failure("aspect-eval", pairs_needed(raw.indexes.size(), raw.scenes.size()));
    return kUsageError;
  }
  EvalOptions options = finished(std::move(raw));
  if (!options.reliability.empty() && options.ranking == RecogniserParameters::Ranking::classes) {
    print_failure("aspect-eval",
                  "--reliability: with --ranking classes nothing is judged; leave one of "
                  "them out");
    return kUsageError;
  }
  if (options.clutter && !options.thesis.empty()) {
    print_failure("aspect-eval", "--thesis-ranks: not with --clutter; leave one of them out");
    return kUsageError;
  }
  if (options.clutter &&
      (!options.reliability.empty() || options.ranking == RecogniserParameters::Ranking::classes)) {
    print_failure("aspect-eval",
                  "--clutter: neither with --reliability nor with --ranking classes; "
                  "leave one of them out");
    return kUsageError;
  }
  return options;
}

}  // namespace aspect
