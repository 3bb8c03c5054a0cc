#include "tools/command_line/command_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "runtime/base/nearest_word.h"

namespace aspect {
std::string positional_heading(const CommandOption& positional) {
  return (positional.value.empty() ? positional.names.front() : positional.value) +
         (positional.repeated ? "..." : "");
}

std::string option_heading(const CommandOption& option) {
  return fmt::format("{}{}{}", fmt::join(option.names, ", "), option.value.empty() ? "" : " ",
                     option.value);
}

std::string usage_of(const CommandText& command) {
  std::string usage;
  for (const CommandOption& option : command.options)
    if (option.required)
      usage +=
          fmt::format("{} {}{} ", option.names.front(), option.value, option.repeated ? "..." : "");
  usage += "[OPTION...]";
  for (const CommandOption& positional : command.positionals) {
    const std::string heading = positional_heading(positional);
    usage += positional.required ? " " + heading : fmt::format(" [{}]", heading);
  }
  return usage;
}

std::string no_such_option(const CommandText& command, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  if (!name.starts_with("--")) return "there is no option " + name;
  std::vector<std::string_view> known;
  for (const CommandOption& option : command.options)
    for (const std::string& one : option.names)
      if (one.starts_with("--")) known.push_back(one);
  return fmt::format("there is no option {}; did you mean {}?", name, likely_word(name, known));
}

std::string_view likely_word(std::string_view word, std::span<const std::string_view> known) {
  for (const std::string_view one : known)
    if (one.starts_with(word)) return one;
  return nearest_word(word, known);
}

std::vector<std::string> groups_of(const CommandText& command) {
  std::vector<std::string> groups;
  for (const CommandOption& option : command.options)
    if (std::find(groups.begin(), groups.end(), option.group) == groups.end())
      groups.push_back(option.group);
  return groups;
}

}  // namespace aspect
