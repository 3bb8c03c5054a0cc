// Options that contradict each other.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tools/aspectc/options/option_table.h"

namespace aspect {

struct SettingsFault {
  std::vector<const Option*> options;  // that take part in it
  std::string what;
};

// How the user wrote an option: as a key or as a flag.
using NameOption = std::function<std::string(const Option& option)>;

std::optional<SettingsFault> find_fault(const CompileSettings& settings, const NameOption& name);

}  // namespace aspect
