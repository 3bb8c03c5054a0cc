// Every option of the compiler, once: from this table come the keys of a project, the flags of the
// command line, the help, and what `aspectc init` writes. A new option is one more entry.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runtime/service/table_reader.h"
#include "tools/aspectc/options/compile_settings.h"

namespace aspect {

// A word is its place among the words of its form.
using OptionValue = std::variant<bool, int, double, std::vector<double>>;

struct TruthForm {};
struct WholeForm {
  ClosedRange<int> range;
};
struct NumberForm {
  ClosedRange<double> range;
};
struct NumbersForm {
  std::size_t count;
  ClosedRange<double> range;
};
struct WordForm {
  std::span<const std::string_view> words;
};
using OptionForm = std::variant<TruthForm, WholeForm, NumberForm, NumbersForm, WordForm>;

struct OptionText {
  std::string_view table, key;
  std::string_view flag;     // as CLI11 has it, with its aliases
  std::string_view unit;     // may be empty
  std::string_view meaning;  // one line, no full stop
  std::string_view advice;   // typical values and what raising it costs; may be empty
};

struct Option {
  OptionText text;
  OptionForm form;
  bool project_wide;  // cannot be said of a single object
  // Nothing: the scene decides.
  std::optional<OptionValue> (*get)(const CompileSettings& settings);
  // The value must be of the option's form and within its range.
  void (*set)(CompileSettings& settings, const OptionValue& value);
};

// In the order in which they are to be shown; those of one table follow one another.
std::span<const Option> compile_option_table();

// Null where there is none.
const Option* find_option(std::string_view table, std::string_view key);

}  // namespace aspect
