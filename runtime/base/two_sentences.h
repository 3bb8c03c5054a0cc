// What is said of a value, wherever it is said: what it is, and what it had better be.
#pragma once

#include <cctype>
#include <string>
#include <string_view>

namespace aspect {

// Of phrases without capital and full stop; the second one may be empty.
inline std::string two_sentences(std::string_view meaning, std::string_view advice) {
  std::string text;
  for (const std::string_view phrase : {meaning, advice}) {
    if (phrase.empty()) continue;
    if (!text.empty()) text += ' ';
    text += static_cast<char>(std::toupper(static_cast<unsigned char>(phrase.front())));
    text += phrase.substr(1);
    text += '.';
  }
  return text;
}

}  // namespace aspect
