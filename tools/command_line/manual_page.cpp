#include "tools/command_line/manual_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace aspect {
namespace {

constexpr std::string_view kExitStatus =
    "0 done; 1 failed: one line on standard error says which file, what is wrong and what to do; 2 "
    "wrong usage.";
constexpr std::string_view kEnvironment =
    "Colours are for terminals alone, and not where TERM is dumb or NO_COLOR is set and not empty.";
constexpr std::array<std::string_view, 9> kFamily = {
    "aspectc(1)",       "aspect-bench(1)",  "aspect-calibrate(1)",
    "aspect-eval(1)",   "aspect-export(1)", "aspect-replay(1)",
    "aspect-report(1)", "aspect-score(1)",  "aspectd(8)"};

// Nothing in it is a request or an escape; a minus is one that can be copied.
std::string escaped(std::string_view text) {
  std::string safe;
  if (text.starts_with('.') || text.starts_with('\'')) safe += "\\&";
  for (const char c : text) {
    if (c == '\\')
      safe += "\\e";
    else if (c == '-')
      safe += "\\-";
    else
      safe += c;
  }
  return safe;
}

// In lines that a person can read, and none of which begins with a blank.
std::string filled(std::string_view text) {
  constexpr std::size_t kColumns = 78;
  std::string lines, line;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find_first_of(" \n"));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    if (word.empty()) continue;
    if (!line.empty() && line.size() + 1 + word.size() > kColumns) {
      lines += line + "\n";
      line.clear();
    }
    // A word may begin a line.
    line += line.empty() ? escaped(word) : " " + escaped(word);
  }
  return line.empty() ? lines : lines + line + "\n";
}

std::string bold(std::string_view word) {
  return fmt::format("\\fB{}\\fR", escaped(word));
}

std::string italic(std::string_view word) {
  return fmt::format("\\fI{}\\fR", escaped(word));
}

std::string capitals(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

// "compiles a coloured CAD model into a class index": what whatis shows.
std::string short_summary(const CommandText& command) {
  std::string text = command.summary.substr(0, command.summary.find(": "));
  if (text.ends_with('.')) text.pop_back();
  text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
  return text;
}

std::string heading_of(const CommandOption& option) {
  std::string heading;
  for (const std::string& name : option.names)
    heading += (heading.empty() ? "" : ", ") + bold(name);
  return option.value.empty() ? heading : heading + " " + italic(option.value);
}

std::string options_of(const CommandText& command) {
  std::string page = ".SH OPTIONS\n";
  const auto groups = groups_of(command);
  for (const std::string& group : groups) {
    if (groups.size() > 1) page += fmt::format(".SS {}\n", escaped(group));
    for (const CommandOption& option : command.options)
      if (option.group == group)
        page += fmt::format(".TP\n{}\n{}", heading_of(option), filled(option.meaning));
  }
  return page;
}

std::string arguments_of(const CommandText& command) {
  if (command.positionals.empty()) return {};
  std::string page = ".SH ARGUMENTS\n";
  for (const CommandOption& one : command.positionals)
    page += fmt::format(".TP\n{}\n{}", italic(positional_heading(one)), filled(one.meaning));
  return page;
}

std::string commands_of(const CommandText& command) {
  if (command.subcommands.empty()) return {};
  std::string page = ".SH COMMANDS\n";
  for (const CommandText& one : command.subcommands)
    page += fmt::format(".TP\n{}(1)\n{}", bold(page_name(one)), filled(one.summary));
  return page;
}

std::string usage_section(const CommandText& command) {
  std::string page =
      fmt::format(".SH SYNOPSIS\n{}\n{}", bold(command.name), filled(usage_of(command)));
  if (!command.subcommands.empty())
    page += fmt::format(".br\n{}\n{} [{}...]\n", bold(command.name), italic("COMMAND"),
                        italic("OPTION"));
  return page;
}

constexpr std::size_t kIndent = 2;

std::string_view take_line(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(line.size() + 1, text.size()));
  return line;
}

bool continues(std::string_view text) {
  return text.starts_with("   ");  // deeper than kIndent
}

// "  word  what it means", and the lines below that are indented deeper.
std::string list_entry(std::string_view line, std::string_view& text) {
  line.remove_prefix(kIndent);
  const std::size_t gap = std::min(line.find("  "), line.size());
  std::string meaning(line.substr(gap));
  while (continues(text)) meaning += "\n" + std::string(take_line(text));
  return fmt::format(".TP\n{}\n{}", bold(line.substr(0, gap)), filled(meaning));
}

// One paragraph, with lists in it, and lines that stay as they are since they begin with spaces.
std::string paragraph(std::string_view text) {
  std::string page, prose;
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    if (!line.starts_with(' ')) {
      prose += std::string(line) + "\n";
      continue;
    }
    page += filled(prose);
    prose.clear();
    if (line.find("  ", kIndent) != std::string_view::npos || continues(text))
      page += list_entry(line, text);
    else
      page += fmt::format(".nf\n{}\n.fi\n", escaped(line));
  }
  return page + filled(prose);
}

struct Notes {
  std::string description, exit_status, files, examples;
};

// Where the paragraph of that title belongs, without the title; else at the description's end.
void add_paragraph(std::string_view text, Notes& notes) {
  const auto add_titled = [text](std::string_view title, std::string& section) {
    if (!text.starts_with(title)) return false;
    section += paragraph(text.substr(std::min(title.size() + 1, text.size())));
    return true;
  };
  if (add_titled("Exit code:", notes.exit_status) || add_titled("Files:", notes.files) ||
      add_titled("Examples:", notes.examples))
    return;
  notes.description += ".PP\n" + paragraph(text);
}

Notes read_notes(std::string_view text) {
  Notes notes;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find("\n\n"), text.size());
    const std::string_view one = text.substr(0, end);
    text.remove_prefix(std::min(end + 2, text.size()));
    const std::size_t begin = one.find_first_not_of('\n');
    if (begin != std::string_view::npos) add_paragraph(one.substr(begin), notes);
  }
  if (notes.exit_status.empty()) notes.exit_status = filled(kExitStatus);
  return notes;
}

std::string titled(std::string_view title, const std::string& text) {
  return text.empty() ? text : fmt::format(".SH {}\n{}", title, text);
}

std::string see_also(const CommandText& program, const CommandText& command) {
  std::vector<std::string> pages(kFamily.begin(), kFamily.end());
  for (const CommandText& one : program.subcommands) pages.push_back(page_name(one) + "(1)");
  std::erase(pages, fmt::format("{}({})", page_name(command), command.section));
  std::sort(pages.begin(), pages.end());
  return filled(fmt::format("{}", fmt::join(pages, ", ")));
}

}  // namespace

std::string page_name(const CommandText& command) {
  std::string name = command.name;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string manual_page(const CommandText& program, const CommandText& command) {
  const Notes notes = read_notes(command.notes);
  std::string page =
      fmt::format(".TH {} {} \"\" \"Aspect {}\" \"Aspect\"\n.SH NAME\n{} \\- {}\n",
                  escaped(capitals(page_name(command))), command.section, program.version,
                  escaped(page_name(command)), escaped(short_summary(command)));
  page += usage_section(command);
  page += titled("DESCRIPTION", filled(command.summary) + notes.description);
  page += commands_of(command) + arguments_of(command) + options_of(command);
  page += titled("EXIT STATUS", notes.exit_status);
  page += titled("ENVIRONMENT", filled(kEnvironment));
  page += titled("FILES", notes.files);
  page += titled("EXAMPLES", notes.examples);
  page += titled("SEE ALSO", see_also(program, command));
  return page;
}

}  // namespace aspect
