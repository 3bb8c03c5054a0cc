// The braces of a statement: a list of fields in any order, each bound to what it fills.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/scene/bob_numbers.h"
#include "compiler/scene/bob_words.h"

namespace aspect {

// The words that begin a statement.
std::span<const std::string_view> statement_names();

// The warnings of one scene: past kMax the rest is only counted, so that a hostile file cannot
// fill the memory with them.
class BobWarnings {
 public:
  static constexpr std::size_t kMax = 100;

  explicit BobWarnings(std::vector<std::string>& lines) : lines_(lines) {}
  void add(const BobWords& words, const BobWord& at, std::string_view message);

 private:
  std::vector<std::string>& lines_;
};

// Three numbers; warns where one is out of 0..1. `name` is the word in front of them.
Eigen::Vector3d read_color(BobWords& words, BobNumbers& numbers, BobWarnings& warnings,
                           const BobWord& name);

// Declares the fields of one statement, then reads them. Throws BobError at an unknown field, one
// given twice, one that is missing, and at whatever a field's own reader finds.
class BobBlock {
 public:
  using Read = std::function<void(const BobWord& field)>;

  BobBlock(BobWords& words, BobNumbers& numbers, BobWarnings& warnings, const BobWord& statement)
      : words_(words), numbers_(numbers), warnings_(warnings), statement_(statement) {}

  void field(std::string_view name, Read read) { fields_.push_back({name, std::move(read)}); }
  // A field that may be given any number of times.
  void repeated(std::string_view name, Read read);
  void number(std::string_view name, double& value);
  void vector(std::string_view name, Eigen::Vector3d& value);
  // Warns where it is out of 0..1.
  void color(std::string_view name, Eigen::Vector3d& value);
  void flag(std::string_view name, bool& value);

  // Checks its range, both ends included.
  void number_within(std::string_view name, double& value, double least, double most);
  void whole_number(std::string_view name, int& value, int least, int most);
  // One of the words that `known` holds; gives its index.
  void word(std::string_view name, std::size_t& index, std::span<const std::string_view> known);
  // Accepted with a warning; `read` takes what follows the name.
  void without_effect(std::string_view name, Read read);

  // Takes everything from { to }.
  void read();

  bool has(std::string_view name) const;
  void require(std::string_view name, std::string_view example) const;

 private:
  struct Field {
    std::string_view name;
    Read read;
    bool repeated = false;
    bool seen = false;
  };

  void read_field();
  [[noreturn]] void unknown_field(const BobWord& word) const;

  BobWords& words_;
  BobNumbers& numbers_;
  BobWarnings& warnings_;
  const BobWord statement_;
  std::vector<Field> fields_;
};

}  // namespace aspect
