#include "tools/command_line/help_text.h"

#include <fmt/format.h>

#include <string_view>

namespace aspect {
namespace {

constexpr std::size_t kColumns = 100, kMeaningColumn = 28;

// The words of `text` from column `indent` on, of which `column` have been written.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t column) {
  std::string lines;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    const bool is_first = column <= indent;
    if (!is_first && column + 1 + word.size() > kColumns) {
      lines += "\n";
      column = 0;
    } else if (!is_first) {
      lines += " ";
      ++column;
    }
    if (column < indent) {
      lines += std::string(indent - column, ' ');
      column = indent;
    }
    lines += word;
    column += word.size();
  }
  return lines + "\n";
}

std::string entry(const std::string& heading, const std::string& meaning) {
  const std::string start = "  " + heading;
  if (start.size() + 2 > kMeaningColumn) return start + "\n" + wrapped(meaning, kMeaningColumn, 0);
  return start + wrapped(meaning, kMeaningColumn, start.size());
}

}  // namespace

std::string help_text(const CommandText& command) {
  std::string text = wrapped(command.summary, 0, 0);
  text += fmt::format("Usage: {} {}\n", command.name, usage_of(command));
  if (!command.subcommands.empty()) {
    text += fmt::format("       {} COMMAND ... (see {} COMMAND --help)\n\nCommands:\n",
                        command.name, command.name);
    for (const CommandText& one : command.subcommands)
      text += entry(one.name.substr(command.name.size() + 1), one.summary);
  }
  if (!command.positionals.empty()) text += "\nArguments:\n";
  for (const CommandOption& positional : command.positionals)
    text += entry(positional_heading(positional), positional.meaning);
  for (const std::string& group : groups_of(command)) {
    text += fmt::format("\n{}:\n", group);
    for (const CommandOption& option : command.options)
      if (option.group == group) text += entry(option_heading(option), option.meaning);
  }
  const std::size_t begin = command.notes.find_first_not_of('\n');
  if (begin != std::string::npos) {
    const std::size_t end = command.notes.find_last_not_of('\n');
    text += "\n" + command.notes.substr(begin, end + 1 - begin) + "\n";
  }
  return text;
}

}  // namespace aspect
