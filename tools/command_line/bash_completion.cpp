#include "tools/command_line/bash_completion.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "tools/command_line/value_words.h"

namespace aspect {
namespace {

// Words cut at "=" are joined again: --option=value is three words to bash. {0} is a name for
// functions, {1} the program, {2} cases "COMMAND:OPTION" of values, {3} cases of commands, {4}
// cases "COMMAND" of all else.
constexpr const char* kScript = R"(# bash completion for {1}; made from its own --help

_{0}_words() {{
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$word")
}}

# Folders, and the files with one of these endings; without any, all files.
_{0}_files() {{
  compopt -o filenames 2>/dev/null
  local ending
  if (($# == 0)); then
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
    return
  fi
  mapfile -t COMPREPLY < <(compgen -d -- "$word"
    for ending; do compgen -f -X "!*.$ending" -- "$word"; done)
}}

_{0}_folders() {{
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$word")
}}

# Whether the option takes the word after it; sets COMPREPLY where that is to be completed.
_{0}_value() {{
  case "$1:$2" in
{2}    *) return 1 ;;
  esac
}}

_{0}() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before='' command='' k
  COMPREPLY=()
  ((COMP_CWORD > 0)) && before=${{COMP_WORDS[COMP_CWORD - 1]}}
  for ((k = 1; k < COMP_CWORD; ++k)); do
    [[ ${{COMP_WORDS[k]}} == = ]] && continue
    [[ ${{COMP_WORDS[k - 1]}} == -* ]] && _{0}_value '' "${{COMP_WORDS[k - 1]}}" && continue
    case ${{COMP_WORDS[k]}} in
{3}      --) command=; break ;;
    esac
  done
  COMPREPLY=()
  compopt +o filenames 2>/dev/null
  if [[ $word == = ]]; then
    word=
  elif [[ $before == = ]] && ((COMP_CWORD > 1)); then
    before=${{COMP_WORDS[COMP_CWORD - 2]}}
  fi
  [[ $before == -* ]] && _{0}_value "$command" "$before" && return
  case $command in
{4}  esac
}}

complete -F _{0} {1}
)";

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

// The call that completes such a value; ":" where nothing is known of it.
std::string action(const ValueWords& words, const std::string& function) {
  if (!words.choices.empty()) return fmt::format("_{}_words '{}'", function, joined(words.choices));
  if (words.is_file)
    return fmt::format("_{}_files{}{}", function, words.endings.empty() ? "" : " ",
                       joined(words.endings));
  return words.is_folder ? fmt::format("_{}_folders", function) : ":";
}

std::string last_word(const std::string& name) {
  return name.substr(name.find(' ') + 1);
}

std::string value_cases(const CommandText& command, const std::string& key,
                        const std::string& function) {
  std::string cases;
  for (const CommandOption& option : command.options) {
    if (option.value.empty() || option.value.starts_with('[')) continue;
    std::vector<std::string> patterns;
    for (const std::string& name : option.names) patterns.push_back(key + ":" + name);
    cases += fmt::format("    {}) {} ;;\n", fmt::join(patterns, " | "),
                         action(value_words(option.value), function));
  }
  return cases;
}

// All that its arguments may be: which one stands here is not counted.
ValueWords argument_words(const CommandText& command) {
  ValueWords all;
  bool any_name = false;
  for (const CommandOption& one : command.positionals) {
    const ValueWords words = value_words(one.value);
    all.is_file |= words.is_file;
    any_name |= words.is_file && words.endings.empty();
    for (const std::string& ending : words.endings)
      if (std::find(all.endings.begin(), all.endings.end(), ending) == all.endings.end())
        all.endings.push_back(ending);
  }
  if (any_name) all.endings.clear();
  return all;
}

std::string argument_case(const CommandText& command, const std::string& key,
                          const std::string& function) {
  std::vector<std::string> options, commands;
  for (const CommandOption& option : command.options)
    options.insert(options.end(), option.names.begin(), option.names.end());
  for (const CommandText& one : command.subcommands) commands.push_back(last_word(one.name));
  std::string text = fmt::format("    {})\n", key.empty() ? "''" : key);
  text += fmt::format(
      "      if [[ $word == -* ]]; then\n        _{}_words '{}'\n        return\n      fi\n",
      function, joined(options));
  text += fmt::format("      {}\n", action(argument_words(command), function));
  if (!commands.empty())
    text += fmt::format(
        "      mapfile -t -O ${{#COMPREPLY[@]}} COMPREPLY < <(compgen -W '{}' -- \"$word\")\n",
        joined(commands));
  return text + "      ;;\n";
}

}  // namespace

std::string bash_completion(const CommandText& program) {
  std::string function = program.name;
  std::replace(function.begin(), function.end(), '-', '_');
  std::string values = value_cases(program, "", function), commands,
              rest = argument_case(program, "", function);
  for (const CommandText& command : program.subcommands) {
    const std::string key = last_word(command.name);
    values += value_cases(command, key, function);
    commands += (commands.empty() ? "" : " | ") + key;
    rest += argument_case(command, key, function);
  }
  if (!commands.empty())
    commands = fmt::format("      {}) command=${{COMP_WORDS[k]}}; break ;;\n", commands);
  return fmt::format(kScript, function, program.name, values, commands, rest);
}

}  // namespace aspect
