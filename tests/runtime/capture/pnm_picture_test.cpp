#include "runtime/capture/pnm_picture.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace aspect {
namespace {

using Catch::Matchers::StartsWith;

std::string fault_of(const std::string& bytes, SensorKind sensor = SensorKind::colour) {
  CapturedFrame frame;
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  return parse_pnm({data, bytes.size()}, sensor, frame).value_or("");
}

TEST_CASE("Headers of PNM may have comments and blanks of every kind") {
  CHECK(fault_of("P5 # 9 9\n#\n\t4\r\n 4 #x\n255\n" + std::string(16, 'a')) == "");
  CHECK(fault_of("P5 # 9 9\n#\n\t4\r\n 4 #x\n255\n" + std::string(15, 'a')) != "");
}

TEST_CASE("PNM pictures that are no good are refused in one line") {
  CHECK_THAT(fault_of(""), StartsWith("an empty file"));
  for (const std::string bytes : {"P", "P5", "P3 4 4 255\n0", "hello", "\x89PNG\r\n\x1a\n"})
    CHECK_THAT(fault_of(bytes), StartsWith("not a picture that is read here"));
  for (const std::string bytes : {"P5\n", "P5 4", "P5 4 4", "P5 x 4 255\n", "P6 -4 4 255\n",
                                  "P6 99999999999 4 255\n", "P6 4 4 #255\n", "P5 #"})
    CHECK_THAT(fault_of(bytes), StartsWith("not a PNM header"));
  CHECK_THAT(fault_of("P6 4 4 255"), StartsWith("cut off"));
  CHECK_THAT(fault_of("P6 4 4 255\n" + std::string(47, 'a')), StartsWith("cut off"));
  CHECK_THAT(fault_of("P6 4 4 65535\n" + std::string(96, 'a')), StartsWith("its largest value"));
  CHECK_THAT(fault_of("P6 3 4 255\n"), StartsWith("3 x 4 px; nothing"));
  CHECK_THAT(fault_of("P6 8200 4 255\n"), StartsWith("8200 x 4 px; at most"));
  CHECK_THAT(fault_of("P6 8000 8000 255\n"), StartsWith("8000 x 8000 px; at most 16"));
  CHECK_THAT(fault_of("P6 4 4 255\n" + std::string(48, 'a'), SensorKind::grey),
             StartsWith("not a grey frame"));
  CHECK_THAT(fault_of("P5 4 4 255\n" + std::string(16, 'a'), SensorKind::range),
             StartsWith("not a range frame"));
}

TEST_CASE("Random bytes behind a PNM magic never get past the file's end") {
  std::mt19937 random(51);
  constexpr std::string_view kLetters = "0123456789 \n\t#P56";
  for (int round = 0; round < 2000; ++round) {
    std::string bytes = random() % 2 == 0 ? "P5" : "P6";
    for (std::size_t k = random() % 40; k > 0; --k) bytes += kLetters[random() % kLetters.size()];
    // A copy of its very size, for the sanitizers.
    const std::vector<char> exact(bytes.begin(), bytes.end());
    CapturedFrame frame;
    const auto* data = reinterpret_cast<const std::uint8_t*>(exact.data());
    const bool read = !parse_pnm({data, exact.size()}, SensorKind::colour, frame);
    if (read) REQUIRE(frame.pixels.size() >= 48);
  }
}

}  // namespace
}  // namespace aspect
