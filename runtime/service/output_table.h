// The [output] table of a configuration: where lines go.
#pragma once

#include <optional>
#include <string>

#include <toml++/toml.h>

#include "runtime/base/result.h"
#include "runtime/output/output_settings.h"

namespace aspect {

// Fills in what the table says and leaves the rest as it is. The error names file and line.
[[nodiscard]] std::optional<Error> read_outputs(const toml::table& table, const std::string& file,
                                                OutputSettings& settings);

}  // namespace aspect
