// A manual page, for man(1), in the macros of man(7).
#pragma once

#include <string>

#include "tools/command_line/command_text.h"

namespace aspect {

// "aspectc-explain"
std::string page_name(const CommandText& command);

// Of the program itself or of one of its commands. No date: the same program
// gives the same bytes.
std::string manual_page(const CommandText& program, const CommandText& command);

}  // namespace aspect
