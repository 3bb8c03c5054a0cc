// Values put into a TOML file that people have written: what they wrote, comments and order, stays.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/store/done.h"
#include "runtime/base/result.h"

namespace aspect {

struct KeyValue {
  std::string key, value;  // the value as TOML has it
};

// The text with these keys in that table: in place where they are there, at the table's end where
// not, and the table at the text's end where there is none. A value must stand in one line.
std::string with_values(std::string_view text, std::string_view table,
                        const std::vector<KeyValue>& values);

// Puts the values into a configuration or a project that is there, or into a new file that begins
// with `head`; written whole or not at all, and only where what comes of it can be read.
Result<Done> put_values(const std::filesystem::path& file, std::string_view head,
                        std::string_view table, const std::vector<KeyValue>& values);

// Of at most 1 MiB; empty where there is no such file.
Result<std::string> read_toml_text(const std::filesystem::path& file);

}  // namespace aspect
