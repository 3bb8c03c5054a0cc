#include "tools/command_line/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string_view>

#include "tools/command_line/app_text.h"
#include "tools/command_line/documents.h"
#include "tools/command_line/help_text.h"
#include "tools/command_line/terminal_colour.h"

namespace aspect {
namespace {

// Of the program, or of the command of it that was given.
const CLI::App& given_command(const CLI::App& app) {
  const auto given = app.get_subcommands();
  return given.empty() ? app : *given.front();
}

std::string full_name(const CLI::App& app) {
  const CLI::App& command = given_command(app);
  return &command == &app ? app.get_name() : app.get_name() + " " + command.get_name();
}

CommandText given_text(const CLI::App& app) {
  CommandText text = app_text(app);
  const std::string name = full_name(app);
  for (CommandText& command : text.subcommands)
    if (command.name == name) return std::move(command);
  return text;
}

// The first word that looks like an option and is none; often it is why something else is missing.
std::string unknown_option(const CLI::App& app) {
  for (const std::string& word : app.remaining(true))
    if (word.size() > 1 && word.front() == '-' && word != "--")
      return no_such_option(given_text(app), word);
  return {};
}

std::string complaint_of(const CLI::ParseError& error, const CLI::App& app) {
  if (const std::string unknown = unknown_option(app); !unknown.empty()) return unknown;
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    if (const auto words = app.remaining(true); !words.empty())
      return words.front() + ": is one word too many";
  return error.what();
}

}  // namespace

std::optional<int> parse_command_line(CLI::App& app, int argc, const char* const* argv) {
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
    command->set_version_flag("--version", app.version());
  if (argc == 3 && argv[1] == std::string_view("--help-documents")) {
    write_documents(app_text(app), argv[2]);
    return 0;
  }
  try {
    app.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", help_text(given_text(app)));
    return 0;
  } catch (const CLI::CallForVersion& version) {
    fmt::print("{}\n", version.what());
    return 0;
  } catch (const CLI::ParseError& error) {
    print_failure(app.get_name(),
                  fmt::format("{}; see {} --help", complaint_of(error, app), full_name(app)));
    return kUsageError;
  }
}

CLI::Option* take_words(CLI::Option* option, const std::vector<std::string>& words) {
  const auto fault_of = [words](const std::string& word) {
    if (std::find(words.begin(), words.end(), word) != words.end()) return std::string();
    const std::vector<std::string_view> known(words.begin(), words.end());
    return fmt::format("{} is none of {}; did you mean {}?", word, fmt::join(words, ", "),
                       likely_word(word, known));
  };
  return option->check(fault_of)->type_name(fmt::format("{}", fmt::join(words, "|")));
}

}  // namespace aspect
