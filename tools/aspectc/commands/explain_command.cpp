#include "tools/aspectc/commands/explain_command.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "tools/aspectc/commands/command_failure.h"
#include "tools/aspectc/project/store_recipe.h"

namespace aspect {
namespace {

constexpr const char* kKeys =
    R"(Keys of --json; shares are 0 to 1, directions unit vectors from the object to the camera:
  accuracy         rank_1, rank_5, rank_10: right aspect among so many, within_20_deg: best view;
                   modulo symmetry; each with share, low and high (95 % interval)
  neighbour_views  views answered with another aspect, but at most 20 degrees off
  wrong_views      views answered with a view farther off, or not at all
  symmetries       quaternions w x y z without the identity; symmetry_axes: round about these
  blind_share      of the sphere, that no aspect covers
  blind_spots      centre, share of the sphere, radius_deg, reason
  failing_spots    centre, share of the views, radius_deg: where wrong answers come from
  confusions       aspect, taken_for (classes of the index), views, seen_from, believed_from,
                   faces, faces_believed (surfaces: primitives of the scene from 1; colour)
  face_confusions  face, taken_for, views, separation (of the colours; above 1 they are separated)
  merged_colours   into so many the colours of the mesh were merged; only where they were
  crowded_colours  colours of a mesh, the share of its surface in ones that touch others too like
                   them, merge_colours: so many would do; only where there are so many
  backgrounds      folder, pictures (looked at, at most 200), colours: surfaces, colour, share of
                   pixels of it, share of pictures with a region of it (0.1 % of a picture and
                   more), commonness (common: 2 % of the pixels or a quarter of the pictures and
                   more; rare: under 0.2 % and a tenth; else occasional), better (a colour less
                   common and far from the others); only with --backgrounds
  cure             changes (face, colour, colour_name, separation), level, wrong_before,
                   wrong_after, cured (of those wrong before), accuracy; only where there is one

Examples:
  aspectc explain part.store
  aspectc explain part.store --backgrounds photos --json)";

}  // namespace

CLI::App* add_explain_command(CLI::App& app, ExplainCommand& command) {
  CLI::App* explain = app.add_subcommand(
      "explain", "Tell what accuracy to expect, and what would cure confusions.");
  explain->add_option("store", command.store, "store of a finished compilation")
      ->required()
      ->type_name("FILE.store");
  explain->add_option("--scene", command.scene, "scene, where the store's cannot be read again")
      ->type_name("SCENE|FILE.toml");
  explain->add_option("--views", command.settings.views, "fresh random views, 1 to 1000000")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000).description(""))
      ->capture_default_str();
  explain->add_option("--seed", command.settings.seed, "of the views")
      ->type_name("N")
      ->capture_default_str();
  explain
      ->add_option("--cure-level", command.settings.cure_level,
                   "level at which changed colours are tried; at most the store's, 0 to 10")
      ->type_name("N")
      ->check(CLI::Range(0, 10).description(""))
      ->capture_default_str();
  explain
      ->add_option("--jobs", command.settings.jobs,
                   "threads, 1 to 1024 [one a core]; changes no result")
      ->type_name("N")
      ->check(CLI::Range(1, 1024).description(""));
  explain
      ->add_option("--backgrounds", command.settings.backgrounds,
                   "folder of pictures of where the object will be used: tells how common its "
                   "colours are in them, and which would be better")
      ->type_name("FOLDER");
  explain->add_flag("--json", command.json, "everything, as one JSON object");
  explain->footer(kKeys);
  return explain;
}

int run_explain(const ExplainCommand& command) {
  const Result<Recipe> recipe = recipe_of_store(command.store, command.scene);
  if (!recipe) return fail(recipe.error());
  const Result<Explanation> explanation = explain(command.store, recipe.value(), command.settings);
  if (!explanation) return fail(explanation.error());
  fmt::print("{}", command.json ? explanation_json(explanation.value())
                                : explanation_text(explanation.value(), shows_colours(stdout)));
  return 0;
}

}  // namespace aspect
