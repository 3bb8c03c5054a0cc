// What a program's command line takes, as plain values: of these its help, its manual page and its
// completions are made, so that an option is described in one place.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aspect {

struct CommandOption {
  std::vector<std::string> names;  // "-o", "--output"; of a positional one word without dashes
  std::string value;               // see value_words.h; empty: the option takes none
  std::string meaning;             // with its default in brackets, as "[10]"
  std::string group;               // heading that it stands under
  bool required = false, repeated = false;
};

struct CommandText {
  std::string name;     // "aspectc explain"
  std::string summary;  // a sentence
  std::string version;  // "0.1.0"
  int section = 1;      // of the manual
  std::vector<CommandOption> options, positionals;
  std::vector<CommandText> subcommands;
  // Paragraphs; lines that begin with spaces stay lines. One that begins with "Exit code:",
  // "Files:" or "Examples:" is a section of the manual.
  std::string notes;
};

// "SCENE", "FRAMES...", "--index FILE.aspect", "-o, --output FILE": as help and manual have it.
std::string positional_heading(const CommandOption& positional);
std::string option_heading(const CommandOption& option);

// What may follow the command's name: "--index FILE.aspect [OPTION...] [FRAMES...]"
std::string usage_of(const CommandText& command);

// The complaint, with the option that the word may stand for; of "--levl=5" too.
std::string no_such_option(const CommandText& command, const std::string& word);

// One that begins so, as "--min-right" for "--min"; else the nearest.
std::string_view likely_word(std::string_view word, std::span<const std::string_view> known);

// Groups in the order of their first options.
std::vector<std::string> groups_of(const CommandText& command);

}  // namespace aspect
