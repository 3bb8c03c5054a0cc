#include "runtime/base/result.h"

#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <vector>

#include "tests/runtime/base/aborting.h"

namespace aspect {
namespace {

Result<int> half_of(int number) {
  if (number % 2 != 0) return Error{"numbers:1: " + std::to_string(number) + " is odd"};
  return number / 2;
}

}  // namespace

TEST_CASE("a result holds the value") {
  const Result<int> result = half_of(8);
  REQUIRE(result.ok());
  REQUIRE(static_cast<bool>(result));
  REQUIRE(result.value() == 4);
}

TEST_CASE("a result holds the error's message") {
  const Result<int> result = half_of(7);
  REQUIRE_FALSE(result.ok());
  REQUIRE_FALSE(static_cast<bool>(result));
  REQUIRE(result.error() == "numbers:1: 7 is odd");
}

TEST_CASE("a result's value can be changed in place and moved out") {
  Result<std::vector<int>> result(std::vector<int>{1, 2});
  result.value().push_back(3);
  const int* data = result.value().data();
  const std::vector<int> moved = std::move(result).value();
  REQUIRE(moved == std::vector<int>{1, 2, 3});
  REQUIRE(moved.data() == data);
}

TEST_CASE("a result carries values that cannot be copied") {
  Result<std::unique_ptr<int>> result(std::make_unique<int>(5));
  const std::unique_ptr<int> moved = std::move(result).value();
  REQUIRE(*moved == 5);
}

TEST_CASE("a string value is not taken for an error") {
  const Result<std::string> result(std::string("fine"));
  REQUIRE(result.ok());
  REQUIRE(result.value() == "fine");
}

TEST_CASE("asking for what a result does not hold aborts") {
  REQUIRE(aborts([] { static_cast<void>(half_of(7).value()); }));
  REQUIRE(aborts([] { static_cast<void>(half_of(8).error().size()); }));
  REQUIRE_FALSE(aborts([] { static_cast<void>(half_of(8).value()); }));
}

}  // namespace aspect
