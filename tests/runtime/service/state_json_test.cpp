#include "runtime/service/state_json.h"

#include <array>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace aspect {
namespace {

using nlohmann::json;

TEST_CASE("A state is a line of JSON with its reason") {
  std::array<char, 200> out;
  const std::size_t length =
      write_state_json("absent", "/dev/\"video\"", "no such\nnode", 12.5, out);
  const std::string line(out.data(), length);
  CHECK(line.back() == '\n');
  CHECK(json::parse(line) == json{{"state", "absent"},
                                  {"camera", "/dev/\"video\""},
                                  {"reason", "no such\nnode"},
                                  {"time_s", 12.5}});
}

TEST_CASE("A state without a reason has no such key") {
  std::array<char, 200> out;
  const std::size_t length = write_state_json("streaming", "c", "", 1, out);
  CHECK_FALSE(json::parse(std::string(out.data(), length)).contains("reason"));
}

TEST_CASE("A state that does not fit is no line") {
  std::array<char, 30> out;
  CHECK(write_state_json("streaming", "a camera with a long name", "", 1, out) == 0);
}

}  // namespace
}  // namespace aspect
