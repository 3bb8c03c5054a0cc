// The manual pages and completions that the build has written: everything that --help shows is in
// them, mandoc has nothing to say against the pages, and bash and zsh themselves complete with the
// scripts.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/child_program.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using Words = std::set<std::string>;

const std::filesystem::path kShare = ASPECT_SHARE;

struct Page {
  std::string name, section;
  std::vector<std::string> command;  // program, and a command of it
};

std::vector<Page> pages() {
  std::vector<Page> all = {{"aspectc", "1", {"aspectc"}},
                           {"aspect-replay", "1", {"aspect-replay"}},
                           {"aspect-eval", "1", {"aspect-eval"}},
                           {"aspect-export", "1", {"aspect-export"}},
                           {"aspect-report", "1", {"aspect-report"}},
                           {"aspect-score", "1", {"aspect-score"}},
                           {"aspectd", "8", {"aspectd"}}};
  if (std::filesystem::exists(std::filesystem::path(ASPECT_PROGRAMS) / "aspect-bench"))
    all.push_back({"aspect-bench", "1", {"aspect-bench"}});
  for (const char* command :
       {"init", "render", "inspect", "convert", "doctor", "explain", "models-info"})
    all.push_back({std::string("aspectc-") + command, "1", {"aspectc", command}});
  return all;
}

std::filesystem::path file_of(const Page& page) {
  return kShare / "man" / ("man" + page.section) / (page.name + "." + page.section);
}

Words lines_of(const std::string& text) {
  Words lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) lines.insert(line);
  return lines;
}

std::string help_of(const TemporaryFolder& here, const Page& page) {
  std::vector<std::string> arguments(page.command.begin() + 1, page.command.end());
  arguments.emplace_back("--help");
  return ChildProgram(std::filesystem::path(ASPECT_PROGRAMS) / page.command.front(), here.path(),
                      arguments)
      .wait()
      .out;
}

// "--output" of "  -o, --output FILE  ...": lines of --help that begin with an option.
Words options_in(const std::string& help) {
  Words options;
  std::istringstream stream(help);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with("  -")) continue;
    std::istringstream words(line);
    for (std::string word; words >> word && word.starts_with('-');)
      options.insert(word.ends_with(',') ? word.substr(0, word.size() - 1) : word);
  }
  return options;
}

// The page as it is read, in one column of plain text.
std::string shown(const TemporaryFolder& here, const Page& page) {
  return run_shell(here.path(),
                   "mandoc -T ascii -O width=400 '" + file_of(page).native() + "' | col -b -x")
      .out;
}

Words bash_offers(const TemporaryFolder& here, const std::string& program,
                  const std::string& words) {
  const auto script = kShare / "bash-completion/completions" / program;
  return lines_of(run_shell(here.path(), "bash " ASPECT_SOURCE_DIR
                                         "/tests/tools/command_line/bash_words.sh " +
                                             script.native() + " " + words)
                      .out);
}

Words zsh_offers(const TemporaryFolder& here, const std::string& line) {
  return lines_of(run_shell(here.path(), "timeout 20 zsh -f " ASPECT_SOURCE_DIR
                                         "/tests/tools/command_line/zsh_words.zsh " +
                                             (kShare / "zsh/vendor-completions").native() + " '" +
                                             line + "'")
                      .out);
}

TEST_CASE("Every option that --help shows is in the manual page, with its value and meaning") {
  const TemporaryFolder here;
  for (const Page& page : pages()) {
    INFO(page.name);
    const std::string help = help_of(here, page), text = shown(here, page);
    const Words options = options_in(help);
    CHECK(options.contains("--help"));
    CHECK(options.contains("--version"));
    for (const std::string& option : options) CHECK_THAT(text, Contains(option));
    // Headings word by word: "-o, --output FILE.png".
    std::istringstream stream(help);
    for (std::string line; std::getline(stream, line);)
      if (line.starts_with("  -"))
        CHECK_THAT(text, Contains(line.substr(2, line.find("  ", 2) - 2)));
    for (const char* section :
         {"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXIT STATUS", "EXAMPLES", "SEE ALSO"})
      CHECK_THAT(text, Contains(std::string("\n") + section + "\n"));
  }
}

TEST_CASE("Lines of help fit into a terminal of 101 columns") {
  const TemporaryFolder here;
  for (const Page& page : pages()) {
    for (const std::string& line : lines_of(help_of(here, page))) {
      INFO(page.name << ": " << line);
      CHECK(line.size() <= 101);
    }
  }
}

TEST_CASE("mandoc has nothing to say against the pages but that they have no date") {
  const TemporaryFolder here;
  for (const Page& page : pages()) {
    const Outcome lint = run_shell(here.path(), "mandoc -T lint '" + file_of(page).native() + "'");
    CHECK_THAT(lint.out, Contains("missing date"));  // it has run
    for (const std::string& line : lines_of(lint.out)) CHECK_THAT(line, Contains("missing date"));
  }
}

TEST_CASE("whatis knows every page, and the pages name each other only where they exist") {
  const TemporaryFolder here;
  std::filesystem::copy(kShare / "man", here.path() / "man",
                        std::filesystem::copy_options::recursive);
  REQUIRE(run_shell(here.path(), "PATH=$PATH:/usr/sbin; makewhatis \"$PWD/man\"").exit_code == 0);
  for (const Page& page : pages()) {
    const Outcome found = run_shell(here.path(), "mwhatis -M \"$PWD/man\" " + page.name);
    CHECK_THAT(found.out, StartsWith(page.name + "(" + page.section + ") - "));
    const std::string also = shown(here, page).substr(shown(here, page).find("SEE ALSO"));
    CHECK_THAT(also, !Contains(page.name + "(" + page.section + ")"));
  }
}

TEST_CASE("The same program writes the same documents") {
  const TemporaryFolder here;
  REQUIRE(run_shell(here.path(), ASPECT_PROGRAMS "/aspectc --help-documents again").exit_code == 0);
  for (const char* file :
       {"man/man1/aspectc.1", "man/man1/aspectc-doctor.1", "bash-completion/completions/aspectc",
        "zsh/vendor-completions/_aspectc"})
    CHECK(read_file(here.path() / "again" / file) == read_file(kShare / file));
}

class Folder : public TemporaryFolder {
 public:
  Folder() {
    for (const char* file : {"part.b", "with space.b", "part.obj", "part.store", "part.aspect",
                             "part.toml", "view.png", "truth.csv"})
      write(file, "");
    std::filesystem::create_directory(path() / "frames");
  }
};

TEST_CASE("bash completes commands, options, their words and files by what they are") {
  const Folder here;
  CHECK(bash_offers(here, "aspectc", "aspectc doc") == Words{"doctor"});
  const Words scenes = {"part.b", "with space.b", "part.obj", "part.toml", "frames"};
  CHECK(bash_offers(here, "aspectc", "aspectc doctor ''") == scenes);
  CHECK(bash_offers(here, "aspectc", "aspectc ''") ==
        Words{"part.b", "with space.b", "part.obj", "part.toml", "frames", "init", "render",
              "inspect", "convert", "doctor", "explain", "models-info"});
  CHECK(bash_offers(here, "aspectc", "aspectc part.b --progress ''") ==
        Words{"auto", "always", "never"});
  CHECK(bash_offers(here, "aspectc", "aspectc --progress = al") == Words{"always"});
  CHECK(bash_offers(here, "aspectc", "aspectc explain --json pa") == Words{"part.store"});
  // The value of an option is no command.
  CHECK(bash_offers(here, "aspectc", "aspectc --stats init --le") == Words{"--level"});
  CHECK(bash_offers(here, "aspect-replay", "aspect-replay --index ''") ==
        Words{"part.aspect", "frames"});
  CHECK(bash_offers(here, "aspect-replay", "aspect-replay --overlay ''") == Words{"frames"});
  CHECK(bash_offers(here, "aspect-replay", "aspect-replay --index x vi") == Words{"view.png"});
  CHECK(bash_offers(here, "aspectd", "aspectd --config ''") == Words{"part.toml", "frames"});
}

TEST_CASE("bash and zsh offer every option that --help shows") {
  const Folder here;
  for (const Page& page : pages()) {
    if (page.command.size() > 1 && page.name != "aspectc-doctor") continue;
    INFO(page.name);
    std::string line;
    for (const std::string& word : page.command) line += word + " ";
    Words expected = options_in(help_of(here, page));
    CHECK(bash_offers(here, page.command.front(), line + "-") == expected);
    std::erase_if(expected, [](const std::string& word) { return !word.starts_with("--"); });
    if (line == "aspectc " || line == "aspectd ")  // a shell takes a quarter of a second
      CHECK(zsh_offers(here, line + "--") == expected);
  }
}

TEST_CASE("zsh completes commands, words and files by what they are") {
  const Folder here;
  CHECK(zsh_offers(here, "aspectc doc") == Words{"doctor"});
  CHECK(zsh_offers(here, "aspectc doctor ") ==
        Words{"part.b", "with space.b", "part.obj", "part.toml", "frames"});
  CHECK(zsh_offers(here, "aspectc part.b --progress ") == Words{"auto", "always", "never"});
  CHECK(zsh_offers(here, "aspectc explain --json pa") == Words{"part.store"});
  CHECK(zsh_offers(here, "aspectc convert part.obj ") == Words{"part.b", "with space.b", "frames"});
  CHECK(zsh_offers(here, "aspect-replay --index=pa") == Words{"part.aspect"});
}

TEST_CASE("An unknown option names the one that was probably meant") {
  const TemporaryFolder here;
  const auto complaint = [&here](const std::string& words) {
    const Outcome outcome = run_shell(here.path(), std::string(ASPECT_PROGRAMS "/") + words);
    CHECK(outcome.exit_code == 2);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    return outcome.err;
  };
  CHECK_THAT(complaint("aspectc part.b --levl 5"), Contains("did you mean --level?"));
  CHECK_THAT(complaint("aspectc doctor --jsn"),
             Contains("did you mean --json?") && Contains("see aspectc doctor --help"));
  CHECK_THAT(complaint("aspect-score --min 3"), Contains("did you mean --min-right?"));
  CHECK_THAT(complaint("aspectd --confg x"), Contains("did you mean --config?"));
  CHECK_THAT(complaint("aspectc part.b --progress sometimes"), Contains("auto, always, never"));
}

}  // namespace
}  // namespace aspect
