// The [segmentation] table that configurations and compile projects share.
#pragma once

#include <optional>
#include <string>

#include <toml++/toml.h>

#include "runtime/base/result.h"
#include "runtime/service/configuration.h"

namespace aspect {

// Fills in what the table says and leaves the rest as it is. The error names file and line.
[[nodiscard]] std::optional<Error> read_segmentation(const toml::table& table,
                                                     const std::string& file,
                                                     SegmentationOverrides& overrides);
[[nodiscard]] std::optional<Error> read_segmentation(const toml::table& table,
                                                     const std::string& file,
                                                     VisionParameters& parameters);

}  // namespace aspect
