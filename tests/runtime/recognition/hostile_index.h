// Index files as an enemy, a bad disk or another version would hand them over.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace aspect {

using IndexBytes = std::vector<std::byte>;

// A real index, small: a cube seen in small pictures.
IndexBytes sample_index_bytes();

// The 20 patches of the viewing sphere, unsplit and of no class.
inline std::vector<std::uint8_t> map_of_nothing() {
  return std::vector<std::uint8_t>(5, 0x55);
}

// Makes the checksum fit again, where the bytes still have a place for it.
void repair_checksum(IndexBytes& bytes);

// 1 to 8 changes: bits, bytes, and whole numbers such as sizes and offsets.
void damage(IndexBytes& bytes, std::mt19937& random);

// Parses, and uses what was accepted: a frame and its golden frame are recognised with it, every
// patch of its sphere map is looked up. Returns the error, or nothing where the bytes were
// accepted.
std::string try_index(std::span<const std::byte> bytes);

}  // namespace aspect
