// What is made of a program's command line when it is built: manual pages and completions.
#pragma once

#include <filesystem>

#include "tools/command_line/command_text.h"

namespace aspect {

// Writes man/man1/PROGRAM.1 and so on of the commands, bash-completion/completions/PROGRAM and
// zsh/vendor-completions/_PROGRAM into that folder, as they lie in /usr/share. Throws where one
// cannot be written.
void write_documents(const CommandText& program, const std::filesystem::path& folder);

}  // namespace aspect
