#include "tools/aspectc/commands/init_command.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "compiler/store/done.h"
#include "tools/aspectc/commands/command_failure.h"
#include "tools/aspectc/project/init_text.h"
#include "tools/aspectc/project/prepared_object.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

// As the project at `project` has to call it.
fs::path seen_from(const fs::path& project, const fs::path& scene) {
  if (scene.is_absolute()) return scene;
  const fs::path relative = fs::proximate(scene, fs::absolute(project).parent_path());
  return relative.empty() ? fs::absolute(scene) : relative;
}

// Never over a file that is there, even one that has just appeared.
Result<Done> write_new_file(const fs::path& file, const std::string& text) {
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "wx"),
                                                         &std::fclose);
  if (!stream && errno == EEXIST)
    return Error{file.native() + ": is there already; remove it, or name another file with -o"};
  if (!stream)
    return Error{fmt::format("{}: cannot be written ({}); check the folder", file.native(),
                             std::strerror(errno))};
  const bool written = std::fwrite(text.data(), 1, text.size(), stream.get()) == text.size();
  if (std::fclose(stream.release()) != 0 || !written)
    return Error{file.native() + ": could not be written to its end; check the disk"};
  return Done{};
}

}  // namespace

CLI::App* add_init_command(CLI::App& app, InitCommand& command) {
  CLI::App* init = app.add_subcommand("init", "Write a commented project for a scene.");
  init->add_option("scene", command.scene, "Bob scene (.b) or mesh")
      ->required()
      ->type_name("SCENE");
  init->add_option("-o,--output", command.output, "project to write [NAME.toml, here]")
      ->type_name("FILE.toml");
  init->footer("Examples:\n  aspectc init part.b\n  aspectc part.toml");
  return init;
}

int run_init(const InitCommand& command) {
  if (fs::path(command.scene).extension() == ".toml")
    return fail(command.scene + ": is a project itself; give a scene");
  const Result<Scene> scene = read_prepared_scene(command.scene, kUncoloured);
  if (!scene) return fail(scene.error());
  const fs::path output(command.output.empty() ? scene.value().name + ".toml" : command.output);
  const std::string text = init_text(seen_from(output, command.scene).native(), scene.value());
  if (auto done = write_new_file(output, text); !done) return fail(done.error());
  fmt::print("{}: edit it, then run aspectc {}\n", output.native(), output.native());
  return 0;
}

}  // namespace aspect
