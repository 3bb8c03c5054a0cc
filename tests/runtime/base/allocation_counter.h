// Counts what a program asks of the heap: linked into a test, it stands in for glibc's allocation
// functions, through which operator new and the libraries go as well.
#pragma once

#include <cstdint>

namespace aspect {

// Requests for memory (malloc, calloc, realloc, aligned ones, new) of all threads since the start.
std::uint64_t allocation_count() noexcept;

}  // namespace aspect
