#include "tools/command_line/app_text.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <set>

namespace aspect {
namespace {

std::string names_of(const std::set<CLI::Option*>& options) {
  std::set<std::string> names;  // by name, not by address
  for (const CLI::Option* option : options) names.insert(option->get_name());
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string meaning_of(const CLI::Option& option) {
  std::string meaning = option.get_description();
  if (!option.get_default_str().empty()) meaning += fmt::format(" [{}]", option.get_default_str());
  if (const auto needed = option.get_needs(); !needed.empty())
    meaning += fmt::format("; only with {}", names_of(needed));
  if (const auto excluded = option.get_excludes(); !excluded.empty())
    meaning += fmt::format("; not with {}", names_of(excluded));
  return meaning;
}

CommandOption option_text(const CLI::Option& option) {
  CommandOption text;
  if (option.get_positional()) text.names.push_back(option.get_name(true));
  for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  if (option.get_items_expected_max() > 0) text.value = option.get_type_name();
  text.meaning = meaning_of(option);
  text.group = option.get_group();
  text.required = option.get_required();
  text.repeated = option.get_expected_max() >= CLI::detail::expected_max_vector_size ||
                  option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
  return text;
}

// Without the program's name, which most programs print before it.
std::string version_of(const CLI::App& app) {
  const std::string version = app.version();
  return version.substr(version.find_last_of(' ') + 1);
}

CommandText text_of(const CLI::App& app, const std::string& before) {
  CommandText text;
  text.name = before + app.get_name();
  text.summary = app.get_description();
  text.version = version_of(app);
  text.notes = app.get_footer();
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    CommandOption one = option_text(*option);
    if (option == app.get_help_ptr()) one.meaning = "print this and end";
    if (option == app.get_version_ptr()) one.meaning = "print the version and end";
    (option->get_positional() ? text.positionals : text.options).push_back(std::move(one));
  }
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    text.subcommands.push_back(text_of(*command, text.name + " "));
    text.subcommands.back().version = text.version;
  }
  return text;
}

}  // namespace

CommandText app_text(const CLI::App& app) {
  return text_of(app, "");
}

}  // namespace aspect
