#include "tools/aspectc/commands/convert_command.h"

#include <CLI/CLI.hpp>

#include <filesystem>

#include "compiler/scene/bob_writer.h"
#include "compiler/scene/scene_reader.h"
#include "tools/aspectc/commands/command_failure.h"
#include "tools/aspectc/commands/whole_file.h"

namespace aspect {
CLI::App* add_convert_command(CLI::App& app, ConvertCommand& command) {
  CLI::App* convert = app.add_subcommand("convert", "Write a scene as a Bob scene.");
  convert->add_option("scene", command.scene, "scene or mesh to read")
      ->required()
      ->type_name("SCENE");
  convert->add_option("output", command.output, "Bob scene to write")
      ->required()
      ->type_name("FILE.b");
  convert
      ->add_option(
          "--missing-colour", command.missing_colour,
          "stands for colours that the scene names and that are not found, each part 0 to 1 [none: "
          "they are an error]")
      ->type_name("R,G,B")
      ->delimiter(',')
      ->expected(3)
      ->check(CLI::Range(0.0, 1.0).description(""));
  convert->footer("Examples:\n  aspectc convert part.obj part.b");
  return convert;
}

int run_convert(const ConvertCommand& command) {
  if (lower_extension(command.output) != ".b")
    return refuse_usage(command.output + ": only Bob scenes are written; name it .b");
  std::error_code unknown;
  if (std::filesystem::equivalent(command.scene, command.output, unknown))
    return refuse_usage(command.output + " is both read and written; name another file");
  SceneReading reading;
  if (!command.missing_colour.empty())
    reading.colours.missing = Eigen::Vector3d(command.missing_colour.data());
  const Result<Scene> scene = read_scene(command.scene, reading);
  if (!scene) return fail(scene.error());
  for (const std::string& warning : scene.value().warnings) print_warning("aspectc", warning);
  for (const MissingColour& missing : scene.value().missing_colours)
    print_warning("aspectc", line_of(missing) + "; --missing-colour stands for it");
  const Result<std::string> text = write_bob(scene.value());
  if (!text) return fail(text.error());
  const Result<Done> done = write_whole_text(command.output, text.value());
  return done ? 0 : fail(done.error());
}

}  // namespace aspect
