// Colours for a person at a terminal, and for nobody else.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace aspect {

// The stream is a terminal that is not dumb, and NO_COLOR is unset or empty (no-color.org).
bool shows_colours(std::FILE* stream);

enum class Tone { good, doubtful, bad };  // green, yellow, red

// The text itself where there are to be no colours.
std::string toned(std::string_view text, Tone tone, bool colours);

// One line on standard error: "aspectc: part.b: cannot be read", "aspectc: warning: ...".
void print_failure(std::string_view program, std::string_view message);
void print_warning(std::string_view program, std::string_view message);

}  // namespace aspect
