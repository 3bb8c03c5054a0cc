// The preprocessed words of a scene as its parsers take them: one word of lookahead, and a record
// of what was taken.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/scene/bob_preprocessor.h"

namespace aspect {

// Throws BobError.
class BobWords {
 public:
  // The record has at most this many bytes: macros can make it longer than the files.
  static constexpr std::size_t kMaxSourceBytes = std::size_t{64} << 20;

  BobWords(BobSources& sources, std::uint32_t main_file,
           std::vector<std::filesystem::path> include_path);

  const BobWord& peek() const { return ahead_; }
  BobWord take();
  // Takes a word that the record has another text for.
  void take_as(std::string_view text);
  bool next_is(std::string_view text) const { return ahead_.text == text; }

  // Takes this very word or fails with what would be right.
  BobWord expect(std::string_view text, std::string_view right);

  // All words taken so far, joined by a space. Signs and operators keep whether they touch their
  // neighbours, because `2 -1` and `2 - 1` differ in meaning.
  const std::string& source() const { return source_; }

  // Adds what the words only name: the contents of another file.
  void add_to_source(std::string_view text) { source_ += text; }

  std::filesystem::path path_named(std::string_view name, const BobWord& word) const {
    return preprocessor_.path_named(name, word);
  }

  std::vector<std::string_view> macro_names() const { return preprocessor_.macro_names(); }

  [[noreturn]] void fail(const BobWord& word, std::string_view message) const {
    preprocessor_.fail(word, message);
  }
  std::string locate(const BobWord& word) const { return preprocessor_.locate(word); }
  std::string line_of(const BobWord& word, std::string_view message) const {
    return preprocessor_.line_of(word, message);
  }

 private:
  BobPreprocessor preprocessor_;
  BobWord ahead_;
  std::string source_;
  bool glue_ = true;
};

// How a word is named in a message.
std::string quoted(const BobWord& word);

bool is_operator(const BobWord& word);

}  // namespace aspect
