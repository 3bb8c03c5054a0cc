// Frames with a truth, put through the programs as their users do.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "tests/recognition_table/table_rows.h"

namespace aspect {

struct SetPrograms {
  std::filesystem::path aspectc, replay;
};

// The index of every scene NAME.b of a folder, as work/NAME.aspect. What is newer than scene and
// compiler is kept.
Result<std::vector<std::filesystem::path>> compiled_scenes(const SetPrograms& programs,
                                                           const std::filesystem::path& scenes,
                                                           int level,
                                                           const std::filesystem::path& work);

// A folder of frames: truth.csv, frames/, camera.toml or segmentation.toml where it has one.
// Objects of the truth that no index is of are nothing to be found. Leaves what aspect-replay said
// as work/seen.ndjson.
Result<SetFigures> measured_set(const SetPrograms& programs, const std::filesystem::path& folder,
                                const std::vector<std::filesystem::path>& indexes,
                                const std::optional<std::filesystem::path>& symmetries,
                                const std::filesystem::path& work);

// Makes such a folder: boards of two to four times two to four fields in random colours on black,
// none of them an object that anybody knows.
void make_boards(const std::filesystem::path& folder, int count);

}  // namespace aspect
