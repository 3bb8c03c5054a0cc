#include "runtime/service/json_text.h"

#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <span>
#include <string>

#include "tests/rounds.h"

namespace aspect {
namespace {

template <typename Value>
std::string text_of(Value value) {
  std::array<char, 4096> buffer;
  JsonText json(buffer);
  json.value(value);
  REQUIRE(json.fits());
  return {buffer.data(), json.size()};
}

std::string read_back(std::string_view text) {
  return nlohmann::json::parse(text_of(text)).get<std::string>();
}

TEST_CASE("Truths and values made before stand between others") {
  std::array<char, 64> buffer;
  JsonText json(buffer);
  json.begin_array();
  json.value(true);
  json.json_value("{\"a\":[]}");
  json.value(false);
  json.end_array();
  CHECK(std::string(buffer.data(), json.size()) == "[true,{\"a\":[]},false]");
}

TEST_CASE("Every float reads back as the same float") {
  std::mt19937 random(7);
  for (int k = 0; k < rounds(20000); ++k) {
    const auto number = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (!std::isfinite(number)) continue;
    const auto parsed = nlohmann::json::parse(text_of(number));
    REQUIRE(parsed.is_number_float());
    REQUIRE(static_cast<float>(parsed.get<double>()) == number);
  }
}

TEST_CASE("Every double reads back as the same double") {
  std::mt19937_64 random(8);
  for (int k = 0; k < rounds(20000); ++k) {
    const auto number = std::bit_cast<double>(static_cast<std::uint64_t>(random()));
    if (!std::isfinite(number)) continue;
    REQUIRE(nlohmann::json::parse(text_of(number)).get<double>() == number);
  }
}

TEST_CASE("Real numbers look like real numbers") {
  CHECK(text_of(5001664.0F) == "5001664.0");
  CHECK(text_of(0.0) == "0.0");
  CHECK(text_of(1.9) == "1.9");
}

TEST_CASE("What is not finite is null") {
  CHECK(text_of(std::numeric_limits<float>::quiet_NaN()) == "null");
  CHECK(text_of(-std::numeric_limits<double>::infinity()) == "null");
}

TEST_CASE("Whole numbers keep all their digits") {
  CHECK(text_of(std::numeric_limits<std::int64_t>::min()) == "-9223372036854775808");
}

TEST_CASE("Quotes, backslashes and control characters are escaped") {
  std::string text = "a\"b\\c\n\t/";
  for (char c = 0; c < 0x20; ++c) text += c;
  text += '\x7F';
  CHECK(read_back(text) == text);
  CHECK(text_of(std::string_view(text)).find('\n') == std::string::npos);
}

TEST_CASE("UTF-8 is kept as it is") {
  const std::string text = "W\xC3\xBCrfel \xE7\xAB\x8B\xE6\x96\xB9 \xF0\x9F\x8E\xB2";
  CHECK(read_back(text) == text);
}

TEST_CASE("Bytes that are not UTF-8 become replacement characters") {
  const std::string replacement = "\xEF\xBF\xBD";
  CHECK(read_back("a\xFFz") == "a" + replacement + "z");
  CHECK(read_back("cut \xE7\xAB") == "cut " + replacement + replacement);
  CHECK(read_back("\xC0\x80") == replacement + replacement);
  CHECK(read_back("\xED\xA0\x80") == replacement + replacement + replacement);
  CHECK(read_back("\xF4\x90\x80\x80").size() == 4 * replacement.size());
}

TEST_CASE("Any bytes make a valid string") {
  std::mt19937 random(9);
  for (int k = 0; k < rounds(2000); ++k) {
    std::string text;
    for (int n = 0; n < 24; ++n) text += static_cast<char>(random() & 0xFFU);
    REQUIRE(nlohmann::json::accept(text_of(std::string_view(text))));
  }
}

TEST_CASE("Commas stand between values and nowhere else") {
  std::array<char, 200> buffer;
  JsonText json(buffer);
  json.begin_object();
  json.key("a");
  json.begin_array();
  json.value(std::int64_t{1});
  json.value(std::string_view("["));
  json.begin_array();
  json.end_array();
  json.value(2.5F);
  json.end_array();
  json.key("b:");
  json.begin_object();
  json.end_object();
  json.end_object();
  CHECK(std::string(buffer.data(), json.size()) == R"({"a":[1,"[",[],2.5],"b:":{}})");
}

TEST_CASE("What does not fit is reported and nothing is written beyond the buffer") {
  std::array<char, 8> memory;
  memory.fill('#');
  JsonText json(std::span<char>(memory).first(5));
  json.begin_array();
  json.value(std::string_view("long text"));
  json.end_array();
  CHECK_FALSE(json.fits());
  CHECK(json.size() <= 5);
  CHECK(std::string(memory.data() + 5, 3) == "###");
}

}  // namespace
}  // namespace aspect
