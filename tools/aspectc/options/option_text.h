// Options and their values as people write and read them.
#pragma once

#include <string>
#include <string_view>

#include "runtime/base/result.h"
#include "tools/aspectc/options/option_table.h"

namespace aspect {

// "5", "[1, 1, 1]", "true", "\"views\"": as in TOML.
std::string toml_text(const Option& option, const OptionValue& value);

// "a whole number from 0 to 10"
std::string form_text(const OptionForm& form);

// Of an argument of the command line; lists are 1,2,3. The error says what it must be.
Result<OptionValue> parse_value(const OptionForm& form, std::string_view text);

// The value of the option's key in a table; nothing where it is absent or no good, which the reader
// then knows.
std::optional<OptionValue> read_value(TableReader& reader, const Option& option);

// "--level" or "[subdivision] level"
std::string flag_name(const Option& option);
std::string key_name(const Option& option);

}  // namespace aspect
