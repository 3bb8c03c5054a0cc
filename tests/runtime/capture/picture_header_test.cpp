#include "runtime/capture/picture_header.h"

#include <catch2/catch.hpp>
#include <random>

#include "tests/runtime/capture/sample_pictures.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

std::string fault_of(std::string_view bytes) {
  return picture_fault(std::as_bytes(std::span(bytes))).value_or("");
}

TEST_CASE("Whole pictures have no fault") {
  for (const char* ending : {".png", ".jpg", ".bmp", ".tiff", ".webp"})
    CHECK(fault_of(encoded(noise(40, 30), ending)) == "");
  CHECK(fault_of("just text") == "");
  CHECK(fault_of("") == "");
}

TEST_CASE("A picture cut off anywhere is noticed") {
  for (const char* ending : {".png", ".jpg"}) {
    const std::string whole = encoded(noise(40, 30), ending);
    for (std::size_t bytes = 8; bytes < whole.size(); ++bytes)
      REQUIRE_THAT(fault_of(whole.substr(0, bytes)), StartsWith("cut off"));
  }
}

TEST_CASE("Bytes behind a picture's end are no fault") {
  for (const char* ending : {".png", ".jpg"})
    CHECK(fault_of(encoded(noise(40, 30), ending) + "trailer") == "");
}

TEST_CASE("Sizes are judged before anything is decoded") {
  const auto flat = [](int rows, int columns) {
    return cv::Mat(rows, columns, CV_8UC1, cv::Scalar(0));
  };
  CHECK_THAT(fault_of(encoded(flat(4, 8193), ".png")), StartsWith("8193 x 4 px; at most 8192"));
  CHECK_THAT(fault_of(encoded(flat(8193, 4), ".jpg")), StartsWith("4 x 8193 px; at most 8192"));
  CHECK_THAT(fault_of(encoded(flat(9000, 4), ".bmp")), StartsWith("4 x 9000 px; at most 8192"));
  CHECK(fault_of(encoded(flat(4, 8192), ".png")) == "");
  CHECK(fault_of(encoded(flat(4000, 4000), ".png")) == "");
  CHECK_THAT(fault_of(encoded(flat(4000, 5000), ".png")),
             StartsWith("5000 x 4000 px; at most 16 megapixels"));
  CHECK_THAT(fault_of(encoded(flat(1, 1), ".png")), StartsWith("1 x 1 px; nothing can be seen"));
  std::string bomb = encoded(noise(4, 4), ".png");
  bomb.replace(16, 8, std::string("\xFF\xFF\xFF\xFF\x7F\xFF\xFF\xFF", 8));
  CHECK_THAT(fault_of(bomb), StartsWith("4294967295 x 2147483647 px"));
  bomb.replace(16, 8, std::string(8, '\0'));
  CHECK_THAT(fault_of(bomb), StartsWith("0 x 0 px"));
}

TEST_CASE("Random damage never leads outside the file") {
  std::mt19937 random(5);
  for (const char* ending : {".png", ".jpg", ".bmp"}) {
    const std::string whole = encoded(noise(16, 16), ending);
    for (int k = 0; k < 3000; ++k) {
      // A copy of the exact size lets the address sanitizer see one byte too many.
      std::vector<std::byte> bytes(whole.size() - random() % whole.size());
      for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(whole[i]);
      for (int n = 0; n < 3; ++n)
        bytes[random() % bytes.size()] = static_cast<std::byte>(random() & 0xFFU);
      static_cast<void>(picture_fault(bytes));
    }
  }
}

}  // namespace
}  // namespace aspect
