// aspectc: compiles a scene into a class index, renders single views, prints indexes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>

#include "tools/aspectc/commands/compile_command.h"
#include "tools/aspectc/commands/convert_command.h"
#include "tools/aspectc/commands/doctor_command.h"
#include "tools/aspectc/commands/explain_command.h"
#include "tools/aspectc/commands/init_command.h"
#include "tools/aspectc/commands/inspect_command.h"
#include "tools/aspectc/commands/models_info_command.h"
#include "tools/aspectc/commands/render_command.h"

namespace aspect {
namespace {

int run_program(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error like a full disk
  CLI::App app{"aspectc compiles a coloured CAD model into a class index for aspectd.", "aspectc"};
  app.set_version_flag("--version", ASPECT_VERSION);
  app.footer(
      "Examples:\n  aspectc part.b -o part.aspect --level 5\n"
      "  aspectc init part.b, edit part.toml, aspectc part.toml\n"
      "  aspectc render part.b --from 1,0.5,0.3 --segmented -o view.png\n"
      "  aspectc inspect part.aspect\n  aspectc inspect part.store\n"
      "  aspectc convert part.obj part.b\n"
      "  aspectc doctor part.obj --fix part.b");
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
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (init->parsed()) return run_init(init_command);
  if (render->parsed()) return run_render(render_command);
  if (inspect->parsed()) return run_inspect(inspect_command);
  if (convert->parsed()) return run_convert(convert_command);
  if (doctor->parsed()) return run_doctor(doctor_command);
  if (explain->parsed()) return run_explain(explain_command);
  if (models_info->parsed()) return run_models_info(models_info_command);
  if (compile_command.scene.empty()) {
    fmt::print(stderr, "aspectc: no scene given; aspectc --help shows how\n");
    return 2;
  }
  return run_compile(compile_command);
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
