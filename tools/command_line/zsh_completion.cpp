#include "tools/command_line/zsh_completion.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "tools/command_line/value_words.h"

namespace aspect {
namespace {

// Within single quotes, and within one of the parts between colons of a specification.
std::string part(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '\'')
      safe += "'\\''";
    else if (c == ':' || c == '[' || c == ']' || c == '\\')
      safe += std::string("\\") + c;
    else
      safe += c;
  }
  return safe;
}

// ":FILE.svg:_files -g '*.svg'"; without an action where nothing is known.
std::string value_part(const std::string& value) {
  const ValueWords words = value_words(value);
  std::string action = " ";
  if (!words.choices.empty())
    action = fmt::format("({})", fmt::join(words.choices, " "));
  else if (words.endings.size() == 1)  // "(a)" at the end would be a qualifier
    action = fmt::format("_files -g \"*.{}\"", words.endings.front());
  else if (!words.endings.empty())
    action = fmt::format("_files -g \"*.({})\"", fmt::join(words.endings, "|"));
  else if (words.is_file)
    action = "_files";
  else if (words.is_folder)
    action = "_files -/";
  return fmt::format(":{}:{}", part(value), action);
}

std::string option_lines(const CommandOption& option) {
  const bool takes_word = !option.value.empty() && !option.value.starts_with('[');
  std::string text;
  for (const std::string& name : option.names) {
    const std::string excluded =
        option.repeated ? "*" : fmt::format("({})", fmt::join(option.names, " "));
    const std::string attached = takes_word && name.starts_with("--") ? "=" : "";
    text += fmt::format("    '{}{}{}[{}]{}'\n", excluded, name, attached, part(option.meaning),
                        takes_word ? value_part(option.value) : "");
  }
  return text;
}

std::string arguments_call(const CommandText& command) {
  std::string text = "  _arguments -s -S \\\n";
  for (const CommandOption& option : command.options) text += option_lines(option);
  for (const CommandOption& one : command.positionals)
    text += fmt::format("    '{}{}'\n",
                        one.repeated   ? "*"
                        : one.required ? ""
                                       : ":",
                        value_part(one.value.empty() ? one.names.front() : one.value));
  std::size_t begin = text.find('\n') + 1;
  for (std::size_t end = text.find('\n', begin); end + 1 < text.size();
       end = text.find('\n', end + 3))
    text.replace(end, 1, " \\\n");
  return text;
}

std::string last_word(const std::string& name) {
  return name.substr(name.find(' ') + 1);
}

// The commands, where the first argument stands; then the command's own arguments.
std::string command_choice(const CommandText& program) {
  std::string text = "  local -a commands=(\n", names;
  for (const CommandText& command : program.subcommands) {
    text += fmt::format("    '{}:{}'\n", last_word(command.name), part(command.summary));
    names += (names.empty() ? "" : "|") + last_word(command.name);
  }
  text += fmt::format(
      "  )\n"
      "  local -i place=${{words[(i)({})]}}\n"
      "  if (( place < CURRENT )); then\n"
      "    local command=$words[place]\n"
      "    words=(\"${{(@)words[place,-1]}}\")\n"
      "    (( CURRENT -= place - 1 ))\n"
      "    _{}_$command\n"
      "    return\n"
      "  fi\n"
      "  [[ $PREFIX != -* && $words[CURRENT-1] != -* ]] && _describe command commands\n",
      names, program.name);
  return text;
}

}  // namespace

std::string zsh_completion(const CommandText& program) {
  std::string text = fmt::format(
      "#compdef {0}\n# zsh completion for {0}; made from its own --help\n", program.name);
  for (const CommandText& command : program.subcommands)
    text += fmt::format("\n_{}_{}() {{\n{}}}\n", program.name, last_word(command.name),
                        arguments_call(command));
  text += fmt::format("\n_{}() {{\n{}{}}}\n\n_{} \"$@\"\n", program.name,
                      program.subcommands.empty() ? "" : command_choice(program),
                      arguments_call(program), program.name);
  return text;
}

}  // namespace aspect
