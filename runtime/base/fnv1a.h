// The 64-bit FNV-1a hash (Fowler, Noll, Vo), byte by byte.
#pragma once

#include <cstdint>

namespace aspect {

inline constexpr std::uint64_t kFnv1aStart = 0xCBF29CE484222325U;

constexpr std::uint64_t fnv1a(std::uint64_t hash, std::uint8_t byte) {
  return (hash ^ byte) * 0x100000001B3U;
}

}  // namespace aspect
