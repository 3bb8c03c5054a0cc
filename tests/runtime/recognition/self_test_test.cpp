// The test at power-on on an index as aspectc writes it: each way to be wrong is noticed in one
// line.
#include "runtime/recognition/self_test.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>

#include "runtime/base/planned_memory.h"
#include "schema/class_index_generated.h"
#include "tests/runtime/recognition/hostile_index.h"

namespace aspect {
namespace {

using Catch::Contains;
using Catch::StartsWith;
using Outcome = SelfTestResult::Outcome;

const IndexBytes& sample_bytes() {
  static const IndexBytes bytes = sample_index_bytes();
  return bytes;
}

const ClassIndex& cube() {
  static const ClassIndex index = parse_index(sample_bytes(), "cube").value();
  return index;
}

SelfTestResult result_after(const std::function<void(ClassIndex&)>& change) {
  ClassIndex index = cube();
  REQUIRE(index.golden);
  change(index);
  return self_test(index);
}

bool is_one_line(const std::string& text) {
  return text.find('\n') == std::string::npos;
}

}  // namespace

TEST_CASE("an answer that is not the expected one fails in a line that says what to do") {
  CHECK(self_test(cube()).outcome == Outcome::passed);
  const auto fails = [](const std::function<void(GoldenFrame&)>& change) {
    const SelfTestResult result = result_after([&](ClassIndex& i) { change(*i.golden); });
    CHECK(is_one_line(result.line));
    CHECK_THAT(result.line, StartsWith("cube: self test: failed") && Contains("copy both again"));
    return result.outcome == Outcome::failed;
  };
  CHECK(fails([](GoldenFrame& g) { g.class_id = g.class_id == 0 ? 1 : 0; }));
  CHECK(fails([](GoldenFrame& g) { g.score -= 0.01F; }));
  CHECK(fails([](GoldenFrame& g) { g.score += 0.01F; }));
  CHECK(fails([](GoldenFrame& g) { --g.matched; }));
  CHECK(fails([](GoldenFrame& g) { ++g.regions; }));
  CHECK(fails([](GoldenFrame& g) { std::swap(g.palette[0], g.palette[1]); }));
}

TEST_CASE("a recogniser that has been made wrong fails") {
  const auto fails = [](const std::function<void(ClassIndex&)>& change) {
    return result_after(change).outcome == Outcome::failed;
  };
  CHECK(fails([](ClassIndex& i) { i.vision.intensity_min = 765; }));  // sees nothing
  CHECK(fails([](ClassIndex& i) {                                     // one region
    i.vision.chroma_step = 255;
    i.vision.intensity_step = 765;
  }));
  CHECK(fails([](ClassIndex& i) { i.vision.area_min_px = 100000; }));
  CHECK(fails([](ClassIndex& i) { std::fill(i.types.begin(), i.types.end(), TypeAttributes{}); }));
  CHECK(fails([](ClassIndex& i) {
    std::swap(i.classes[0], i.classes[i.golden->class_id + 1U]);
    std::swap(i.classes[0], i.classes[i.golden->class_id]);
  }));
  CHECK(fails([](ClassIndex& i) {
    for (KeyContour& k : i.key_contours) k.feature.position.x = -k.feature.position.x;
  }));
}

TEST_CASE("of several indexes the first that fails is named, and one without golden frame passes") {
  std::vector<ClassIndex> indexes(3, cube());
  CHECK_FALSE(self_test(std::span<const ClassIndex>(indexes)));
  indexes[0].golden.reset();
  CHECK_FALSE(self_test(std::span<const ClassIndex>(indexes)));
  indexes[1].object = "second";
  indexes[1].golden->score = 0;
  indexes[2].golden->score = 0;
  const std::optional<Error> error = self_test(std::span<const ClassIndex>(indexes));
  REQUIRE(error);
  CHECK_THAT(error->message, StartsWith("second: "));
}

TEST_CASE("the test runs in memory that is handed over, one index after the other") {
  std::vector<ClassIndex> indexes(2, cube());
  indexes[1].golden->score = 0;
  const std::size_t bytes = self_test_bytes(indexes);
  CHECK(bytes == self_test_bytes(std::span(indexes).first(1)));
  CHECK(bytes > golden_picture_bytes(*cube().golden, SensorKind::colour));
  PlannedMemory planned;
  std::span<std::byte> memory;
  planned.plan([&](Arena& arena) { memory = arena.take<std::byte>(bytes); });
  CHECK_FALSE(self_test(std::span<const ClassIndex>(indexes).first(1), memory));
  CHECK(self_test(std::span<const ClassIndex>(indexes), memory));
  std::fill(indexes.begin(), indexes.end(), ClassIndex{});
  CHECK(self_test_bytes(indexes) == 0);
  CHECK_FALSE(self_test(std::span<const ClassIndex>(indexes)));
}

TEST_CASE("a golden frame changed behind the checksum's back is refused or fails") {
  const IndexBytes& sample = sample_bytes();
  const auto* golden = schema::GetClassIndex(sample.data())->golden_frame();
  REQUIRE(golden != nullptr);
  const auto* data = reinterpret_cast<const std::uint8_t*>(sample.data());
  const auto first = static_cast<std::size_t>(golden->rows()->Data() - data);
  int noticed = 0, flips = 0;
  for (std::size_t bit = 0; bit < 8U * golden->rows()->size(); bit += 3, ++flips) {
    IndexBytes bytes = sample;
    bytes[first + bit / 8] ^= static_cast<std::byte>(1U << bit % 8);
    CHECK_THAT(parse_index(bytes, "flipped").error(), Contains("checksum does not fit"));
    repair_checksum(bytes);
    const Result<ClassIndex> index = parse_index(bytes, "flipped");
    noticed += !index || self_test(index.value()).outcome == Outcome::failed ? 1 : 0;
  }
  // A border that moves by a pixel in a few rows changes nothing that counts.
  INFO(noticed << " of " << flips);
  CHECK(noticed > flips * 8 / 10);
}

TEST_CASE("an index says in one line that its golden frame cannot be") {
  using Root = schema::ClassIndex;
  const IndexBytes& sample = sample_bytes();
  const auto refused = [&](flatbuffers::voffset_t field, std::uint16_t value) {
    IndexBytes bytes = sample;
    auto* golden = const_cast<schema::GoldenFrame*>(
        flatbuffers::GetMutableRoot<Root>(bytes.data())->golden_frame());
    CHECK(reinterpret_cast<flatbuffers::Table*>(golden)->SetField(field, value, std::uint16_t{1}));
    repair_checksum(bytes);
    return try_index(bytes).find("hostile: holds a golden frame that cannot be") == 0;
  };
  using Golden = schema::GoldenFrame;
  for (const unsigned number : {0U, 1U, 65535U}) {
    const auto bad = static_cast<std::uint16_t>(number);
    CHECK(refused(Golden::VT_WIDTH_PX, bad));
    CHECK(refused(Golden::VT_HEIGHT_PX, bad));
  }
  CHECK(refused(Golden::VT_CLASS_ID, 65535));
}

}  // namespace aspect
