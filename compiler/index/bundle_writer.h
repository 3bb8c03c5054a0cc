// Several class indexes as the bytes of one file.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace aspect {

// schema/index_bundle.fbs; the same indexes give the same bytes.
std::vector<std::uint8_t> write_bundle(std::span<const std::vector<std::uint8_t>> indexes);

}  // namespace aspect
