// One table of a TOML file, read key by key: types and ranges are checked, keys that nobody asked
// for are errors.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "runtime/base/result.h"

namespace aspect {

template <typename Number>
struct ClosedRange {
  Number least, most;
};

class TableReader {
 public:
  // `table` must outlive the reader. `section` is its name; empty: the whole file.
  TableReader(const toml::table& table, std::string file, std::string section);

  // A key that is absent leaves the value as it is.
  void read(std::string_view key, ClosedRange<int> range, std::optional<int>& value);
  void read(std::string_view key, ClosedRange<double> range, std::optional<double>& value);
  void read(std::string_view key, ClosedRange<double> range, std::optional<float>& value);
  void read(std::string_view key, std::optional<bool>& value);
  void read(std::string_view key, std::optional<std::string>& value);
  void read(std::string_view key, ClosedRange<int> range, std::optional<std::array<int, 4>>& value);
  // An array of that many numbers.
  void read(std::string_view key, std::size_t count, ClosedRange<double> range,
            std::optional<std::vector<double>>& value);
  void read(std::string_view key, ClosedRange<int> range, std::vector<int>& values);
  // An array of texts, not empty.
  void read(std::string_view key, std::optional<std::vector<std::string>>& value);
  // The value becomes the place of the word found.
  void read(std::string_view key, std::span<const std::string_view> words,
            std::optional<std::size_t>& value);
  // Whatever keys it has, each with a whole number, in the order of the file.
  void read(std::string_view key, std::vector<std::pair<std::string, std::int64_t>>& numbers);
  // A table in this one, null where there is none.
  const toml::table* table(std::string_view key);
  // The tables of a [[key]], none where there is none.
  std::vector<const toml::table*> tables(std::string_view key);

  // Says of a key that is there what is wrong with it, of one that is not that it is missing.
  void fail(std::string_view key, std::string_view what);
  void require(std::string_view key);

  // The error that comes first in the file, unknown keys included.
  std::optional<Error> finish();

 private:
  const toml::node* find(std::string_view key);
  void fail_at(std::uint32_t line, std::string message);
  void refuse(std::string_view key, const toml::node& node, std::string_view wanted);
  std::string place_of(std::string_view key) const;

  const toml::table& table_;
  std::string file_, section_;
  std::vector<std::string_view> known_;
  std::uint32_t error_line_ = 0;
  std::optional<std::string> error_;
};

}  // namespace aspect
