#include "compiler/scene/bob_block.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "runtime/base/nearest_word.h"

namespace aspect {
namespace {

constexpr std::array<std::string_view, 11> kStatements = {
    "studio", "light", "surface",  "polygon",   "patch",        "sphere",
    "ring",   "cone",  "cylinder", "transform", "transform_pop"};

}  // namespace

std::span<const std::string_view> statement_names() {
  return kStatements;
}

void BobWarnings::add(const BobWords& words, const BobWord& at, std::string_view message) {
  if (lines_.size() < kMax) {
    lines_.push_back(words.line_of(at, message));
  } else if (lines_.size() == kMax) {
    lines_.push_back(words.line_of(at, "more warnings are left out; mend the first ones"));
  }
}

void BobBlock::repeated(std::string_view name, Read read) {
  fields_.push_back({name, std::move(read), true});
}

void BobBlock::number(std::string_view name, double& value) {
  field(name, [this, &value](const BobWord&) { value = numbers_.number(); });
}

void BobBlock::vector(std::string_view name, Eigen::Vector3d& value) {
  field(name, [this, &value](const BobWord&) { value = numbers_.vector(); });
}

Eigen::Vector3d read_color(BobWords& words, BobNumbers& numbers, BobWarnings& warnings,
                           const BobWord& name) {
  const Eigen::Vector3d color = numbers.color();
  if (color.minCoeff() < 0 || color.maxCoeff() > 1) {
    warnings.add(words, name,
                 fmt::format("{} {:g} {:g} {:g} is out of 0..1; write parts of 1", name.text,
                             color.x(), color.y(), color.z()));
  }
  return color;
}

void BobBlock::color(std::string_view name, Eigen::Vector3d& value) {
  field(name, [this, &value](const BobWord& word) {
    value = read_color(words_, numbers_, warnings_, word);
  });
}

void BobBlock::flag(std::string_view name, bool& value) {
  field(name, [&value](const BobWord&) { value = true; });
}

void BobBlock::number_within(std::string_view name, double& value, double least, double most) {
  field(name, [this, &value, least, most](const BobWord& word) {
    value = numbers_.number();
    if (value >= least && value <= most) return;
    words_.fail(word, fmt::format("{} {:g}; write a number within {:g} .. {:g}", word.text, value,
                                  least, most));
  });
}

void BobBlock::whole_number(std::string_view name, int& value, int least, int most) {
  field(name, [this, &value, least, most](const BobWord& word) {
    const double number = numbers_.number();
    if (number != std::floor(number) || number < least || number > most) {
      words_.fail(word, fmt::format("{} {:g}; write a whole number within {} .. {}", word.text,
                                    number, least, most));
    }
    value = static_cast<int>(number);
  });
}

void BobBlock::word(std::string_view name, std::size_t& index,
                    std::span<const std::string_view> known) {
  field(name, [this, &index, known](const BobWord& field) {
    const BobWord word = words_.take();
    const auto found = std::find(known.begin(), known.end(), word.text);
    if (found == known.end()) {
      words_.fail(word, fmt::format("unknown word {} behind {}; the nearest known one is '{}'",
                                    quoted(word), field.text, nearest_word(word.text, known)));
    }
    index = static_cast<std::size_t>(found - known.begin());
  });
}

void BobBlock::without_effect(std::string_view name, Read read) {
  field(name, [this, read = std::move(read)](const BobWord& word) {
    read(word);
    warnings_.add(words_, word, fmt::format("{} has no effect; leave it out", word.text));
  });
}

void BobBlock::read() {
  words_.expect("{", fmt::format("write {} {{ ... }}", statement_.text));
  while (!words_.next_is("}")) read_field();
  words_.take();
}

void BobBlock::read_field() {
  const BobWord word = words_.peek();
  const auto found = std::find_if(fields_.begin(), fields_.end(),
                                  [&](const Field& known) { return known.name == word.text; });
  if (found == fields_.end()) unknown_field(word);
  if (found->seen && !found->repeated) {
    words_.fail(word,
                fmt::format("{} given twice in {}; write it once", word.text, statement_.text));
  }
  found->seen = true;
  words_.take();
  found->read(word);
}

void BobBlock::unknown_field(const BobWord& word) const {
  const auto statements = statement_names();
  if (word.kind == BobWord::Kind::kEnd ||
      std::find(statements.begin(), statements.end(), word.text) != statements.end()) {
    words_.fail(word, fmt::format("{} inside {}, opened at {}; close it with }} before",
                                  quoted(word), statement_.text, words_.locate(statement_)));
  }
  std::vector<std::string_view> known;
  for (const Field& candidate : fields_) known.push_back(candidate.name);
  if (word.kind == BobWord::Kind::kNumber || is_operator(word)) {
    words_.fail(word, fmt::format("{} is a number too many in {}; write a field such as {}",
                                  quoted(word), statement_.text, known.front()));
  }
  words_.fail(word, fmt::format("unknown word {} in {}; the nearest known one is '{}'",
                                quoted(word), statement_.text, nearest_word(word.text, known)));
}

bool BobBlock::has(std::string_view name) const {
  return std::any_of(fields_.begin(), fields_.end(),
                     [&](const Field& known) { return known.name == name && known.seen; });
}

void BobBlock::require(std::string_view name, std::string_view example) const {
  if (has(name)) return;
  words_.fail(statement_, fmt::format("{} without {}; write {}", statement_.text, name, example));
}

}  // namespace aspect
