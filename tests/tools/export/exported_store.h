// A small store, made once for the tests of a program, and what aspect-export makes of it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compiler/stored_model.h"
#include "tests/child_program.h"
#include "tests/temporary_folder.h"

namespace aspect {

// l_shape in small pictures at level 2.
const std::filesystem::path& sample_store();
const StoredModel& sample_model();
std::span<const std::uint8_t> sample_index_bytes();

Outcome run_export(const std::filesystem::path& folder, const std::vector<std::string>& arguments);

}  // namespace aspect
