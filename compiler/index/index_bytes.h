// An index as a file: arrays, map and what is known of the whole object, with a checksum.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/index/index_arrays.h"
#include "compiler/index/index_contents.h"
#include "runtime/recognition/class_index.h"

namespace aspect {

std::vector<std::uint8_t> index_bytes(const IndexContents& contents, const IndexArrays& arrays,
                                      const std::vector<std::uint8_t>& map,
                                      const std::optional<GoldenFrame>& golden);

// Written over the one that the bytes have.
void set_calibration(std::vector<std::uint8_t>& bytes, const Calibration& calibration);

}  // namespace aspect
