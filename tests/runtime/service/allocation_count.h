// Counts what this test program takes from the heap.
#pragma once

#include <cstddef>

namespace aspect {

std::size_t allocation_count();

}  // namespace aspect
