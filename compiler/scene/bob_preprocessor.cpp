#include "compiler/scene/bob_preprocessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

namespace aspect {
namespace {

// Far above any real scene: each bounds time or memory that a hostile file could ask for.
constexpr std::size_t kMaxWordLength = 128;
constexpr std::size_t kMaxQuotedLength = 4096;

}  // namespace

BobPreprocessor::BobPreprocessor(BobSources& sources, std::uint32_t main_file,
                                 std::vector<std::filesystem::path> include_path)
    : sources_(sources), include_path_(std::move(include_path)) {
  open(main_file);
}

void BobPreprocessor::open(std::uint32_t file) {
  std::error_code code;
  std::filesystem::path real_path = std::filesystem::weakly_canonical(sources_.path(file), code);
  files_.push_back({file, std::move(real_path), BobLexer(sources_.text(file)), {}, 0});
}

void BobPreprocessor::close_file() {
  const OpenFile& file = files_.back();
  if (file.lexer.open_comment_line() != 0) {
    sources_.fail({file.file, file.lexer.open_comment_line()},
                  "this comment is never closed; write */ behind it (comments do not nest)");
  }
  if (!file.conditions.empty()) {
    sources_.fail(file.conditions.back().opened,
                  "this condition is never closed; write #endif in the same file");
  }
  if (files_.size() == 1) end_.place = {file.file, file.lexer.line()};
  files_.pop_back();
}

BobWord BobPreprocessor::next() {
  BobWord word;
  while (next_of_expansion(word) || next_of_file(word)) {
    const auto found = word.kind == BobWord::Kind::kName ? macros_.find(word.text) : macros_.end();
    if (found == macros_.end()) return word;
    expand(found->second, word);
  }
  return end_;
}

bool BobPreprocessor::next_of_expansion(BobWord& word) {
  while (!expansions_.empty()) {
    Expansion& expansion = expansions_.back();
    if (expansion.position < expansion.macro->body.size()) {
      const bool first = expansion.position == 0;
      word = expansion.macro->body[expansion.position++];
      word.place = expansion.use.place;
      word.space_before = word.space_before || first;
      word.after_macro = std::exchange(after_macro_, false);
      if (++expanded_words_ > kMaxExpandedWords) {
        fail(word, fmt::format("the macros expand past {} words; define less at a time",
                               kMaxExpandedWords));
      }
      return true;
    }
    expansion.macro->expanding = false;
    expansions_.pop_back();
    after_macro_ = true;
  }
  return false;
}

void BobPreprocessor::expand(std::shared_ptr<Macro> macro, const BobWord& use) {
  if (macro->expanding) expansion_cycle(use);
  macro->expanding = true;
  expansions_.push_back({std::move(macro), use, 0});
}

void BobPreprocessor::expansion_cycle(const BobWord& use) const {
  auto step = std::find_if(expansions_.begin(), expansions_.end(), [&](const Expansion& expansion) {
    return expansion.use.text == use.text;
  });
  std::string chain;
  constexpr int kShownSteps = 8;
  for (int shown = 0; step != expansions_.end(); ++step, ++shown) {
    if (shown == kShownSteps) {
      chain += "... -> ";
      break;
    }
    chain += fmt::format("{} -> ", step->use.text);
  }
  fail(use, fmt::format("macro {0} expands to itself ({1}{0}); use another name in its body",
                        use.text, chain));
}

bool BobPreprocessor::next_of_file(BobWord& word) {
  while (!files_.empty()) {
    const RawWord raw = files_.back().lexer.next();
    if (raw.kind == RawWord::Kind::kEndOfText) {
      close_file();
    } else if (raw.kind == RawWord::Kind::kEndOfLine) {
      continue;
    } else if (raw.starts_line && raw.text == "#") {
      directive(raw);
    } else if (files_.back().failing_conditions == 0) {
      word = checked(raw);
      word.after_macro = std::exchange(after_macro_, false);
      return true;
    }
  }
  return false;
}

BobWord BobPreprocessor::checked(const RawWord& raw) const {
  const Place place = place_of(raw);
  const bool is_quoted = raw.kind == RawWord::Kind::kQuoted;
  const std::size_t longest = is_quoted ? kMaxQuotedLength : kMaxWordLength;
  if (raw.text.size() > longest) {
    sources_.fail(place, fmt::format("a word of {} characters; a word has at most {}",
                                     raw.text.size(), longest));
  }
  BobWord word;
  word.text = raw.text;
  word.place = place;
  word.space_before = raw.space_before;
  word.space_after = raw.space_after;
  if (raw.kind == RawWord::Kind::kName) {
    word.kind = BobWord::Kind::kName;
  } else if (raw.kind == RawWord::Kind::kNumber) {
    word.kind = BobWord::Kind::kNumber;
  } else if (is_quoted) {
    word.kind = BobWord::Kind::kQuoted;
  } else {
    const auto byte = static_cast<unsigned char>(raw.text.front());
    if (byte <= 0x20 || byte >= 0x7f) {
      sources_.fail(place, fmt::format("byte 0x{:02x} outside a comment; write ASCII text", byte));
    }
    if (byte == '"') sources_.fail(place, "a quote that is not closed; write \"name\"");
    if (std::string_view("{}()+-*/").find(raw.text.front()) == std::string_view::npos) {
      sources_.fail(place, fmt::format("'{}' means nothing here; remove it", raw.text));
    }
    word.kind = BobWord::Kind::kSymbol;
  }
  return word;
}

std::filesystem::path BobPreprocessor::path_named(std::string_view name,
                                                  const BobWord& word) const {
  const Place& written = word.macro.empty() ? word.place : word.macro_place;
  std::filesystem::path path = sources_.path(written.file).parent_path() / name;
  const auto is_there = [this](const std::filesystem::path& candidate) {
    sources_.note(candidate);
    std::error_code code;
    return std::filesystem::exists(candidate, code);
  };
  if (is_there(path)) return path;
  for (const auto& folder : include_path_)
    if (is_there(folder / name)) return folder / name;
  return path;
}

std::vector<std::string_view> BobPreprocessor::macro_names() const {
  std::vector<std::string_view> names;
  names.reserve(macros_.size());
  for (const auto& [name, macro] : macros_) names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

std::string BobPreprocessor::line_of(const BobWord& word, std::string_view message) const {
  if (word.macro.empty()) return sources_.line_of(word.place, message);
  return sources_.line_of(word.place, fmt::format("{} (in macro {}, {})", message, word.macro,
                                                  sources_.locate(word.macro_place)));
}

void BobPreprocessor::fail(const BobWord& word, std::string_view message) const {
  throw BobError(line_of(word, message));
}

}  // namespace aspect
