// Which known word an unknown one was probably meant to be.
#pragma once

#include <span>
#include <string_view>

namespace aspect {

// The known word with the least edit distance (insert, remove or change one letter), the first of
// equals; empty where none is known. O(known * length^2).
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> known);

}  // namespace aspect
