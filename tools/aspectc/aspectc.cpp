// aspectc: compiles a scene into a class index, renders single views, prints indexes.
#include <CLI/CLI.hpp>
#include <csignal>

#include "tools/aspectc/commands/command_failure.h"
#include "tools/aspectc/commands/compile_command.h"
#include "tools/aspectc/commands/convert_command.h"
#include "tools/aspectc/commands/doctor_command.h"
#include "tools/aspectc/commands/explain_command.h"
#include "tools/aspectc/commands/init_command.h"
#include "tools/aspectc/commands/inspect_command.h"
#include "tools/aspectc/commands/models_info_command.h"
#include "tools/aspectc/commands/render_command.h"
#include "tools/command_line/command_line.h"

namespace aspect {
namespace {

constexpr const char* kNotes =
    R"(The options from [camera] on are the keys of a project as well, under these tables; aspectc init
writes one that explains them all. What a scene was compiled from is kept beside its index, in
NAME.aspect.inputs: where nothing has changed, nothing is compiled. A run that was stopped goes on
from its store.

Files:
  NAME.b            Bob scene; with NAME.bo and NAME.bc where it includes them
  NAME.obj .ply .stl .gltf .glb .dxf .off .3ds .3mf .step .stp
                    mesh with materials, face or vertex colours
  NAME.toml         project: names scenes and says what the options say
  NAME.aspect       class index, for aspect-replay and aspectd
  NAME.store        database of views and matches, for aspectc explain

Examples:
  aspectc part.b -o part.aspect --level 5
  aspectc init part.b
  aspectc part.toml)";

int run_program(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error like a full disk
  CLI::App app{"Compiles a coloured CAD model into a class index for aspectd.", "aspectc"};
  app.set_version_flag("--version", ASPECT_VERSION);
  CompileCommand compile_command;
  add_compile_options(app, compile_command);
  InitCommand init_command;
  CLI::App* init = add_init_command(app, init_command);
  RenderCommand render_command;
  CLI::App* render = add_render_command(app, render_command);
  InspectCommand inspect_command;
  CLI::App* inspect = add_inspect_command(app, inspect_command);
  ConvertCommand convert_command;
  CLI::App* convert = add_convert_command(app, convert_command);
  DoctorCommand doctor_command;
  CLI::App* doctor = add_doctor_command(app, doctor_command);
  ExplainCommand explain_command;
  CLI::App* explain = add_explain_command(app, explain_command);
  ModelsInfoCommand models_info_command;
  CLI::App* models_info = add_models_info_command(app, models_info_command);
  // Last: a command would take it over.
  app.footer(kNotes);
  if (const auto exit_code = parse_command_line(app, argc, argv)) return *exit_code;
  if (init->parsed()) return run_init(init_command);
  if (render->parsed()) return run_render(render_command);
  if (inspect->parsed()) return run_inspect(inspect_command);
  if (convert->parsed()) return run_convert(convert_command);
  if (doctor->parsed()) return run_doctor(doctor_command);
  if (explain->parsed()) return run_explain(explain_command);
  if (models_info->parsed()) return run_models_info(models_info_command);
  if (compile_command.scene.empty())
    return refuse_usage("no scene given; aspectc --help shows how");
  return run_compile(compile_command);
}

}  // namespace
}  // namespace aspect

int main(int argc, char** argv) {
  try {
    return aspect::run_program(argc, argv);
  } catch (const std::exception& error) {
    return aspect::fail(error.what());
  }
}
