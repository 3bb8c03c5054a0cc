// The outcome of something that may fail for a reason outside this program: a value, or one line
// that says which file, where, what is wrong and what to do.
#pragma once

#include <string>
#include <utility>
#include <variant>

#include "runtime/base/check.h"

namespace aspect {

struct Error {
  std::string message;
};

template <typename Value>
class [[nodiscard]] Result {
 public:
  Result(Value value) : outcome_(std::move(value)) {}
  Result(Error error) : outcome_(std::move(error)) {}

  bool ok() const { return std::holds_alternative<Value>(outcome_); }
  explicit operator bool() const { return ok(); }

  Value& value() & {
    ASPECT_CHECK(ok());
    return *std::get_if<Value>(&outcome_);
  }
  const Value& value() const& {
    ASPECT_CHECK(ok());
    return *std::get_if<Value>(&outcome_);
  }
  Value value() && {
    ASPECT_CHECK(ok());
    return std::move(*std::get_if<Value>(&outcome_));
  }
  const std::string& error() const {
    ASPECT_CHECK(!ok());
    return std::get_if<Error>(&outcome_)->message;
  }

 private:
  std::variant<Value, Error> outcome_;
};

}  // namespace aspect
