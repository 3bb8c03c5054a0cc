#include "tools/export/export_options.h"

#include <CLI/CLI.hpp>
#include <vector>

#include "tools/command_line/command_line.h"

namespace aspect {
namespace {

constexpr const char* kDescription =
    "Writes the model in a store as text files: those of the thesis's appendix A.2.";

constexpr const char* kFooter = R"(
The files, with NAME the object's, N the level and +X+Y+Z the direction of a view:
  NAME+X+Y+Z.sgm    a view's attributed relational graph: nodes and arcs
  NAME+X+Y+Z.chn8   its contours as chain codes
  NAME.N.vert       the views, their directions and numbers of regions
  NAME.N.part       the patches of the viewing sphere by partition (aspect, class)
  NAME.N.det        the views of each partition and their nodes, named alike within it
  NAME.attr         the attribute vectors of all these nodes
  NAME.means        their mean by contour type
  NAME.class        each class by the contour types of its regions
Partition and class K are class K - 1 of the index and of aspect-replay. What aspect-replay
--thesis-index writes, NAME.index, goes with NAME.class.

The folder is made where there is none. All files are written aside first; then each replaces the
one that has its name. Other files stay: of another level, of views that are no more. Graphs, chain
codes and attributes are of pictures rendered again from the scene in the store; all but .vert,
.part and .class need them.

Exit code: 0 done, 1 the store or a file was no good (one line on standard error), 2 wrong usage.

Examples:
  aspect-export part.store part_files
  aspect-export part.store part_files --level 4 --format part --format class
)";

void add_options(CLI::App& app, ExportOptions& options, std::vector<std::string>& formats) {
  constexpr int kMostLevel = 10, kMostJobs = 1024;
  app.add_option("store", options.store, "store of a finished compilation")
      ->required()
      ->type_name("FILE.store");
  app.add_option("folder", options.folder, "where the files go")->required()->type_name("FOLDER");
  app.add_option("--level", options.level,
                 "the model as it was when this level was complete; below the store's without "
                 "views on borders, 0 to 10 [the store's]")
      ->check(CLI::Range(0, kMostLevel).description(""))
      ->type_name("N");
  app.add_flag(
      "--without-borders", options.without_borders,
      "without views on borders between aspects, as the thesis's models are; the classes are "
      "not the index's then");
  take_words(app.add_option("--format", formats, "write this one; repeat it for more [all]")
                 ->allow_extra_args(false)
                 ->expected(1)
                 ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll),
             {kExportFormats.begin(), kExportFormats.end()});
  app.add_option("--scene", options.scene, "scene, where the store's cannot be read again")
      ->type_name("SCENE|FILE.toml");
  app.add_option("--jobs", options.jobs, "threads, 1 to 1024 [one a core]; changes no result")
      ->check(CLI::Range(1, kMostJobs).description(""))
      ->type_name("N");
}

}  // namespace

std::variant<ExportOptions, int> parse_export_options(int argc, const char* const* argv) {
  CLI::App app(kDescription, "aspect-export");
  app.footer(kFooter);
  app.set_version_flag("--version", "aspect-export " ASPECT_VERSION);
  ExportOptions options;
  std::vector<std::string> formats;
  add_options(app, options, formats);
  if (const auto exit_code = parse_command_line(app, argc, argv)) return *exit_code;
  options.formats.insert(formats.begin(), formats.end());
  return options;
}

}  // namespace aspect
