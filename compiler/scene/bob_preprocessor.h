// Turns a scene file into one stream of words: includes opened, conditions decided, macros
// expanded. Works word by word, so that memory does not grow with the expansion.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "compiler/scene/bob_lexer.h"
#include "compiler/scene/bob_sources.h"

namespace aspect {

struct BobWord {
  enum class Kind { kName, kNumber, kQuoted, kSymbol, kEnd };

  Kind kind = Kind::kEnd;
  std::string_view text;
  Place place;             // in a file: where the outermost macro is used
  std::string_view macro;  // the innermost macro this word stands in; empty outside
  Place macro_place;       // of the word in that macro's body
  bool space_before = false;
  bool space_after = false;
  bool after_macro = false;  // the first word behind an expansion
};

// Lives no longer than the sources, whose texts its words view. Throws BobError.
class BobPreprocessor {
 public:
  // Words taken out of macro bodies, in all; past it the file is a bomb.
  static constexpr std::size_t kMaxExpandedWords = 1'000'000;

  // `main_file` is an index into `sources`, which gains the included files.
  BobPreprocessor(BobSources& sources, std::uint32_t main_file,
                  std::vector<std::filesystem::path> include_path);

  // At the end of the scene, kEnd for ever.
  BobWord next();

  std::vector<std::string_view> macro_names() const;

  // Where a file named in this word's file is: beside that file or on the include path.
  std::filesystem::path path_named(std::string_view name, const BobWord& word) const;

  // Ends the reading with an error about this word.
  [[noreturn]] void fail(const BobWord& word, std::string_view message) const;
  std::string line_of(const BobWord& word, std::string_view message) const;
  std::string locate(const BobWord& word) const { return sources_.locate(word.place); }

 private:
  struct Macro {
    std::vector<BobWord> body;
    bool expanding = false;
  };

  struct Expansion {
    std::shared_ptr<Macro> macro;
    BobWord use;
    std::size_t position = 0;
  };

  struct Condition {
    Place opened;
    bool holds = false;
    bool else_seen = false;
  };

  struct OpenFile {
    std::uint32_t file = 0;
    std::filesystem::path real_path;
    BobLexer lexer;
    std::vector<Condition> conditions;
    std::size_t failing_conditions = 0;
  };

  void open(std::uint32_t file);
  void close_file();
  bool next_of_expansion(BobWord& word);
  bool next_of_file(BobWord& word);
  BobWord checked(const RawWord& raw) const;
  Place place_of(const RawWord& raw) const { return {files_.back().file, raw.line}; }
  void expand(std::shared_ptr<Macro> macro, const BobWord& use);
  void expansion_cycle(const BobWord& use) const;

  void directive(const RawWord& hash);
  BobWord name_of_directive(const BobWord& directive_word);
  void end_of_directive(const BobWord& directive_word);
  void skip_line();
  void include(const BobWord& directive_word);
  void define(const BobWord& directive_word);
  void begin_condition(const BobWord& directive_word, bool wanted);
  void flip_condition(const BobWord& directive_word);
  void end_condition(const BobWord& directive_word);

  BobSources& sources_;
  std::vector<std::filesystem::path> include_path_;
  std::vector<OpenFile> files_;
  std::vector<Expansion> expansions_;
  std::unordered_map<std::string_view, std::shared_ptr<Macro>> macros_;
  std::size_t expanded_words_ = 0;
  std::size_t defined_words_ = 0;
  std::size_t includes_ = 0;
  bool after_macro_ = false;
  BobWord end_;
};

}  // namespace aspect
