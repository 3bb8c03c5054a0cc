#include "tools/aspectc/options/option_flags.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "tools/aspectc/options/option_text.h"

namespace aspect {
namespace {

// As it is given on the command line: a word without quotes.
std::string default_text(const Option& option, const OptionValue& value) {
  std::string text = toml_text(option, value);
  std::erase(text, '"');
  return text;
}

std::string help_of(const Option& option) {
  std::string help(option.text.meaning);
  if (!option.text.unit.empty()) help += fmt::format(" ({})", option.text.unit);
  if (const auto value = option.get({})) help += fmt::format(" [{}]", default_text(option, *value));
  if (!option.text.advice.empty()) help += fmt::format("; {}", option.text.advice);
  return help;
}

std::string type_of(const Option& option) {
  if (const auto* words = std::get_if<WordForm>(&option.form))
    return fmt::format("{}", fmt::join(words->words, "|"));
  if (const auto* numbers = std::get_if<NumbersForm>(&option.form))
    return numbers->count == 2 ? "A,B" : "A,B,C";
  if (std::holds_alternative<WholeForm>(option.form)) return "N";
  return std::holds_alternative<TruthForm>(option.form) ? "true|false" : "X";
}

}  // namespace

void add_option_flags(CLI::App& app, std::vector<GivenFlag>& given) {
  for (const Option& option : compile_option_table()) {
    const auto take = [&option, &given](const std::string& text) {
      const Result<OptionValue> value = parse_value(option.form, text);
      if (!value) throw CLI::ValidationError(flag_name(option), value.error());
      given.push_back({&option, value.value()});
    };
    app.add_option_function<std::string>(std::string(option.text.flag), take, help_of(option))
        ->type_name(type_of(option))
        ->group(fmt::format("[{}]", option.text.table));
  }
}

}  // namespace aspect
