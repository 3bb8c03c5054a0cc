// The lines of a scene that begin with #: the half of BobPreprocessor that changes what the other
// half reads.
#include <fmt/format.h>

#include <array>
#include <system_error>
#include <utility>

#include "compiler/scene/bob_preprocessor.h"
#include "runtime/base/nearest_word.h"

namespace aspect {
namespace {

constexpr std::array<std::string_view, 7> kDirectives = {"include", "define", "undef", "ifdef",
                                                         "ifndef",  "else",   "endif"};

// Far above any real scene: each bounds time or memory that a hostile file could ask for. Depth
// also catches a cycle through links that hide that two paths are one file.
constexpr std::size_t kMaxIncludeDepth = 64;
constexpr std::size_t kMaxIncludes = 10'000;
constexpr std::size_t kMaxMacros = 10'000;
constexpr std::size_t kMaxDefinedWords = BobPreprocessor::kMaxExpandedWords;
constexpr std::size_t kMaxConditions = 1'000;

}  // namespace

void BobPreprocessor::directive(const RawWord& hash) {
  const RawWord raw = files_.back().lexer.next();
  BobWord word;
  word.text = raw.text;
  word.place = place_of(hash);
  const std::string_view name = raw.text;
  if (name == "ifdef") return begin_condition(word, true);
  if (name == "ifndef") return begin_condition(word, false);
  if (name == "else") return flip_condition(word);
  if (name == "endif") return end_condition(word);
  if (files_.back().failing_conditions > 0) {
    if (raw.kind != RawWord::Kind::kEndOfLine) skip_line();
    return;
  }
  if (name == "include") return include(word);
  if (name == "define") return define(word);
  if (name == "undef") {
    const BobWord macro = name_of_directive(word);
    end_of_directive(word);
    macros_.erase(macro.text);
    return;
  }
  if (raw.kind != RawWord::Kind::kName) {
    fail(word, "# without a directive; write #include, #define, #undef or a condition");
  }
  checked(raw);
  fail(word, fmt::format("unknown directive #{}; the nearest known one is #{}", name,
                         nearest_word(name, kDirectives)));
}

BobWord BobPreprocessor::name_of_directive(const BobWord& directive_word) {
  const RawWord raw = files_.back().lexer.next();
  if (raw.kind != RawWord::Kind::kName) {
    fail(directive_word, fmt::format("#{0} without a name; write #{0} NAME", directive_word.text));
  }
  return checked(raw);
}

void BobPreprocessor::end_of_directive(const BobWord& directive_word) {
  const RawWord raw = files_.back().lexer.next();
  if (raw.kind == RawWord::Kind::kEndOfLine || raw.kind == RawWord::Kind::kEndOfText) return;
  fail(directive_word,
       fmt::format("more words behind #{}; put them on a line of their own", directive_word.text));
}

void BobPreprocessor::skip_line() {
  for (RawWord raw = files_.back().lexer.next();
       raw.kind != RawWord::Kind::kEndOfLine && raw.kind != RawWord::Kind::kEndOfText;) {
    raw = files_.back().lexer.next();
  }
}

void BobPreprocessor::include(const BobWord& directive_word) {
  const auto name = files_.back().lexer.file_name();
  if (!name) fail(directive_word, "the file's name is not closed; write #include \"name\"");
  if (name->empty()) fail(directive_word, "#include without a file; write #include \"name\"");
  end_of_directive(directive_word);
  if (files_.size() >= kMaxIncludeDepth) {
    fail(directive_word,
         fmt::format("files included more than {} deep; include less deeply", kMaxIncludeDepth));
  }
  if (++includes_ > kMaxIncludes) {
    fail(directive_word, fmt::format("more than {} includes; join the files", kMaxIncludes));
  }
  const std::filesystem::path path = path_named(*name, directive_word);
  std::error_code code;
  const std::filesystem::path real_path = std::filesystem::weakly_canonical(path, code);
  for (const OpenFile& open_file : files_) {
    if (code || open_file.real_path != real_path) continue;
    fail(directive_word, fmt::format("{} includes itself; break the cycle", path.string()));
  }
  Result<std::string> text = load_text(path, sources_.bytes_left());
  if (!text.ok()) fail(directive_word, fmt::format("{}: {}", path.string(), text.error()));
  open(sources_.add(path, std::move(text).value(), directive_word.place));
}

void BobPreprocessor::define(const BobWord& directive_word) {
  const BobWord name = name_of_directive(directive_word);
  auto macro = std::make_shared<Macro>();
  for (RawWord raw = files_.back().lexer.next();
       raw.kind != RawWord::Kind::kEndOfLine && raw.kind != RawWord::Kind::kEndOfText;
       raw = files_.back().lexer.next()) {
    if (macro->body.empty() && raw.text == "(" && !raw.space_before) {
      fail(directive_word, "macros have no parameters; write a space behind the name");
    }
    BobWord word = checked(raw);
    word.macro = name.text;
    word.macro_place = word.place;
    macro->body.push_back(word);
    if (++defined_words_ > kMaxDefinedWords) {
      fail(directive_word,
           fmt::format("the macros hold more than {} words; define less", kMaxDefinedWords));
    }
  }
  macros_.insert_or_assign(name.text, std::move(macro));
  if (macros_.size() > kMaxMacros) {
    fail(directive_word, fmt::format("more than {} macros; define less", kMaxMacros));
  }
}

void BobPreprocessor::begin_condition(const BobWord& directive_word, bool wanted) {
  const BobWord name = name_of_directive(directive_word);
  end_of_directive(directive_word);
  OpenFile& file = files_.back();
  if (file.conditions.size() >= kMaxConditions) {
    fail(directive_word, fmt::format("conditions more than {} deep; nest less", kMaxConditions));
  }
  const bool holds = macros_.contains(name.text) == wanted;
  file.conditions.push_back({directive_word.place, holds, false});
  if (!holds) ++file.failing_conditions;
}

void BobPreprocessor::flip_condition(const BobWord& directive_word) {
  end_of_directive(directive_word);
  OpenFile& file = files_.back();
  if (file.conditions.empty()) {
    fail(directive_word, "#else without a condition; write #ifdef NAME before it");
  }
  Condition& condition = file.conditions.back();
  if (condition.else_seen) {
    fail(directive_word, "a second #else of one condition; write #endif before it");
  }
  condition.else_seen = true;
  condition.holds = !condition.holds;
  if (condition.holds) {
    --file.failing_conditions;
  } else {
    ++file.failing_conditions;
  }
}

void BobPreprocessor::end_condition(const BobWord& directive_word) {
  end_of_directive(directive_word);
  OpenFile& file = files_.back();
  if (file.conditions.empty()) {
    fail(directive_word, "#endif without a condition; write #ifdef NAME before it");
  }
  if (!file.conditions.back().holds) --file.failing_conditions;
  file.conditions.pop_back();
}

}  // namespace aspect
