// aspectc explain FILE.store: what to expect of a compiled model, and what would make it better.
#pragma once

#include <string>

#include "tools/explain/explanation.h"

namespace CLI {
class App;
}

namespace aspect {

struct ExplainCommand {
  std::string store, scene;
  ExplainSettings settings;
  bool json = false;
};

CLI::App* add_explain_command(CLI::App& app, ExplainCommand& command);
int run_explain(const ExplainCommand& command);

}  // namespace aspect
