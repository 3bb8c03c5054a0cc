// Lines of aspect-replay as a page takes them, and what others may put in their place.
#include "tools/frame_page/page_line.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tools/frame_page/page_block.h"

namespace aspect {
namespace {

using Catch::Matchers::StartsWith;
using nlohmann::json;

json hypothesis(double score) {
  return {{"object", "cube"},
          {"class", 7},
          {"score", score},
          {"matched", 3},
          {"unmatched", 1},
          {"view", {0.6, 0.0, 0.8}},
          {"pose",
           {{"quaternion", {0.5, 0.5, -0.5, 0.5}},
            {"translation", {0.25, -1.5, 30.123456789}},
            {"reprojection_px", 0.25},
            {"covariance", json::array()}}},
          {"contours", {{0, "A"}, {2, "B"}}}};
}

json whole_line() {
  json object = {{"box", {10, 20, 30, 40}},
                 {"regions", 4},
                 {"verdict", "match"},
                 {"probability", 0.987654321}};
  for (int k = 0; k < 12; ++k) object["hypotheses"].push_back(hypothesis(1 - 0.01 * k));
  json contradicts = json::array();
  for (int k = 0; k < 15; ++k)
    contradicts.push_back({{"contour", k}, {"colour", {0.2, 0.3, 0.5}}, {"area_px", 1234.5}});
  object["explanation"] = {
      {"contours", {{{"contour", 0}, {"name", "A"}, {"surfaces", {1, 2}}, {"colour", {1, 0, 0}}}}},
      {"missing", {{{"colour", {0, 1, 0}}, {"area_px", 99.0}, {"covered", 0.25}}}},
      {"contradicts", contradicts},
      {"expected",
       {{"reason", "it scores less"},
        {"chosen", false},
        {"on_shortlist", false},
        {"matched", 1},
        {"needed", 3}}}};
  return {{"frame", "frames/1.png"},
          {"sequence", 4},
          {"width", 640},
          {"height", 480},
          {"elapsed_ms", 1.23456789},
          {"stages_ms", {{"pose", 0.5}}},
          {"objects", {object}}};
}

std::string error_of(const std::string& line) {
  const auto read = read_page_line(line, "seen.jsonl:7");
  return read ? "" : read.error();
}

}  // namespace

TEST_CASE("A line is kept as it is, but for what a page has no need of") {
  const auto read = read_page_line(whole_line().dump(), "seen.jsonl:1");
  REQUIRE(read);
  const PageLine& line = read.value();
  CHECK(line.frame == "frames/1.png");
  CHECK(line.sequence == 4);
  CHECK(line.summary["ms"] == 1.235);
  const json expected = {{"box", {10.0, 20.0, 30.0, 40.0}},
                         {"regions", 4},
                         {"verdict", "match"},
                         {"p", 0.9877},
                         {"object", "cube"},
                         {"class", 7},
                         {"score", 1.0}};
  CHECK(line.summary["objects"] == json::array({expected}));
  const json& object = line.details["objects"][0];
  CHECK(object["hypotheses"].size() == kPageHypotheses);
  CHECK(object["hypotheses"][9]["score"] == 0.91);
  CHECK_FALSE(object["hypotheses"][0]["pose"].contains("covariance"));
  CHECK(object["explanation"]["contradicts"].size() == kPageRows);
  CHECK(object["explanation"]["contradicts_more"] == 15 - kPageRows);
  CHECK(object["explanation"]["expected"]["reason"] == "it scores less");
  REQUIRE(line.poses.size() == 1);
  CHECK(line.poses[0].object == "cube");
  CHECK(line.poses[0].pose.rotation.y == -0.5);
  CHECK(line.poses[0].pose.translation[2] == Approx(30.123456789));
  CHECK(line.found.objects.size() == 1);
}

TEST_CASE("An unknown object's pose is not drawn, and an object without hypotheses is no fault") {
  json line = whole_line();
  line["objects"][0]["verdict"] = "unknown";
  line["objects"].push_back({{"box", {0, 0, 1, 1}},
                             {"regions", 0},
                             {"verdict", "unknown"},
                             {"probability", 0},
                             {"hypotheses", json::array()}});
  const auto read = read_page_line(line.dump(), "x:1");
  REQUIRE(read);
  CHECK(read.value().poses.empty());
  CHECK(read.value().summary["objects"].size() == 2);
  CHECK_FALSE(read.value().summary["objects"][1].contains("object"));
}

TEST_CASE("A line that is cut off anywhere is told in one line with its place") {
  const std::string line = whole_line().dump();
  for (std::size_t length = 0; length < line.size(); length += 3) {
    const std::string error = error_of(line.substr(0, length));
    REQUIRE_THAT(error, StartsWith("seen.jsonl:7: not a line of aspect-replay ("));
    REQUIRE(std::count(error.begin(), error.end(), '\n') == 0);
    REQUIRE(error.size() < 300);
  }
}

TEST_CASE("What aspect-replay cannot have written is refused") {
  const auto changed = [](const char* pointer, const json& value) {
    json line = whole_line();
    line[json::json_pointer(pointer)] = value;
    return error_of(line.dump());
  };
  for (const auto& [pointer, value] : std::vector<std::pair<const char*, json>>{
           {"/frame", 3},
           {"/width", -1},
           {"/height", 1e300},
           {"/sequence", 0.5},
           {"/objects", "none"},
           {"/objects/0/box", {1, 2, 3}},
           {"/objects/0/verdict", "</script>"},
           {"/objects/0/hypotheses", nullptr},
           {"/objects/0/hypotheses/0/class", -3},
           {"/objects/0/hypotheses/0/view", {1, 0}},
           {"/objects/0/hypotheses/0/pose/quaternion", {1, 1, 1, 1}},
           {"/objects/0/hypotheses/0/pose/translation", {0, 0, 1e200}},
           {"/objects/0/hypotheses/0/contours/0", {1}},
           {"/objects/0/explanation/missing", 5},
           {"/objects/0/explanation/contradicts/0/colour", {"r", "g", "b"}}}) {
    INFO(pointer << " " << value);
    CHECK_THAT(changed(pointer, value), StartsWith("seen.jsonl:7: "));
  }
  for (const std::string& line :
       {std::string("[]"), std::string("null"), std::string("{}"), std::string("\xff\xfe{}"),
        std::string(100000, '['), "{\"frame\":\"" + std::string(5000, 'x'),
        std::string("{\"frame\":\"a\",\"width\":1e999}"), std::string(3, '\0'),
        std::string(kMostLineBytes + 1, ' ')})
    CHECK_THAT(error_of(line), StartsWith("seen.jsonl:7: "));
  const std::string told = error_of("{\"frame\":\"\x1b[31m\xff\xfe\"");
  CHECK(std::all_of(told.begin(), told.end(), [](char c) { return c >= 0x20 && c < 0x7F; }));
}

TEST_CASE("What a name holds cannot end the element that it is in") {
  const std::string block =
      json_block("data-frame", {{"name", "</script><!--<script>alert(1)\xff"}});
  CHECK(block.find('<', 1) == block.rfind("</script>"));
  const std::size_t begin = block.find('>') + 1;
  const json back = json::parse(block.substr(begin, block.rfind("</script>") - begin));
  CHECK(back["name"] == "</script><!--<script>alert(1)\xef\xbf\xbd");
}

TEST_CASE("Numbers are as short as their digits, and finite") {
  CHECK(json(with_digits(0.123456789, 4)).dump() == "0.1235");
  CHECK(json(with_digits(-1234567.0, 9)).dump() == "-1234567.0");
  CHECK(with_digits(std::numeric_limits<double>::infinity(), 4) == 0);
}

}  // namespace aspect
