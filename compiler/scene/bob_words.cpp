#include "compiler/scene/bob_words.h"

#include <fmt/format.h>

#include <utility>

namespace aspect {

std::string quoted(const BobWord& word) {
  return word.kind == BobWord::Kind::kEnd ? "the end of the file" : fmt::format("'{}'", word.text);
}

bool is_operator(const BobWord& word) {
  return word.kind == BobWord::Kind::kSymbol &&
         std::string_view("+-*/").find(word.text.front()) != std::string_view::npos;
}

BobWords::BobWords(BobSources& sources, std::uint32_t main_file,
                   std::vector<std::filesystem::path> include_path)
    : preprocessor_(sources, main_file, std::move(include_path)), ahead_(preprocessor_.next()) {}

BobWord BobWords::take() {
  const BobWord word = ahead_;
  if (word.kind == BobWord::Kind::kEnd) return word;
  const bool touches = is_operator(word) && !word.space_before && !word.after_macro;
  if (!glue_ && !touches) source_ += ' ';
  glue_ = is_operator(word) && !word.space_after;
  source_ += word.text;
  if (source_.size() > kMaxSourceBytes) {
    fail(word, fmt::format("the scene is longer than {} MiB; divide it", kMaxSourceBytes >> 20));
  }
  ahead_ = preprocessor_.next();
  return word;
}

void BobWords::take_as(std::string_view text) {
  source_ += text;
  glue_ = false;
  ahead_ = preprocessor_.next();
}

BobWord BobWords::expect(std::string_view text, std::string_view right) {
  if (!next_is(text))
    fail(ahead_, fmt::format("{} in place of '{}'; {}", quoted(ahead_), text, right));
  return take();
}

}  // namespace aspect
