// aspectc doctor FILE: what is wrong with a model before time is spent on it.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace aspect {

struct DoctorCommand {
  std::string file, fix, picture;
  int merge_colours = 0;  // 0: as the project has it
  bool json = false, all = false;
};

CLI::App* add_doctor_command(CLI::App& app, DoctorCommand& command);
int run_doctor(const DoctorCommand& command);

}  // namespace aspect
