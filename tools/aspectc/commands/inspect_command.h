// aspectc inspect FILE: an index in words, or as JSON; a store likewise.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace aspect {

struct InspectCommand {
  std::string index;
  bool json = false;
  std::string golden;  // picture to write the golden frame to
  std::string sheet;   // picture to write a tile of every class to
};

CLI::App* add_inspect_command(CLI::App& app, InspectCommand& command);
int run_inspect(const InspectCommand& command);

}  // namespace aspect
