// aspectc SCENE|PROJECT.toml: from scenes to class indexes.
#pragma once

#include <string>
#include <vector>

#include "tools/aspectc/options/option_flags.h"

namespace CLI {
class App;
}

namespace aspect {

struct CompileCommand {
  std::string scene, output, store, statistics, progress = "auto";
  bool no_store = false, force = false;
  std::vector<GivenFlag> flags;
};

void add_compile_options(CLI::App& app, CompileCommand& command);

// The program's exit code.
int run_compile(const CompileCommand& command);

}  // namespace aspect
