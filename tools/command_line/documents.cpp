#include "tools/command_line/documents.h"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

#include "tools/command_line/bash_completion.h"
#include "tools/command_line/manual_page.h"
#include "tools/command_line/zsh_completion.h"

namespace aspect {
namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::binary);
  stream << text << std::flush;
  if (!stream) throw std::runtime_error(file.native() + ": cannot be written; check the folder");
}

void write_page(const CommandText& program, const CommandText& command,
                const std::filesystem::path& folder) {
  const int section = command.section;
  write(folder / fmt::format("man/man{}/{}.{}", section, page_name(command), section),
        manual_page(program, command));
}

}  // namespace

void write_documents(const CommandText& program, const std::filesystem::path& folder) {
  write_page(program, program, folder);
  for (const CommandText& command : program.subcommands) write_page(program, command, folder);
  write(folder / "bash-completion/completions" / program.name, bash_completion(program));
  write(folder / "zsh/vendor-completions" / ("_" + program.name), zsh_completion(program));
}

}  // namespace aspect
