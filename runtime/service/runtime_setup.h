// A configuration with all that it names.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/recognition/class_index.h"
#include "runtime/service/configuration.h"

namespace aspect {

struct RuntimeSetup {
  Configuration configuration;
  std::vector<ClassIndex> indexes;  // loaded, checked and tested
  RecogniserParameters parameters;
  std::vector<std::string> warnings;  // one line each
};

// On the heap, since recognisers point to its indexes. Everything must be right: one index that is
// not is the error of all.
Result<std::unique_ptr<RuntimeSetup>> load_setup(const std::filesystem::path& file);

// Of a text that is to be the file's: why it would be no good there. The camera is not asked.
[[nodiscard]] std::optional<Error> check_setup(const std::string& text,
                                               const std::filesystem::path& file);

}  // namespace aspect
