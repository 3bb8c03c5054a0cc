#include "runtime/service/recognition_json.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/runtime/service/allocation_count.h"

namespace aspect {
namespace {

using nlohmann::json;

// A made-up result with the memory that it points to.
class MadeUp {
 public:
  MadeUp(std::size_t objects, std::size_t hypotheses, unsigned seed) : random_(seed) {
    indexes_.resize(2);
    indexes_[0].object = "cube \"one\"";
    indexes_[1].object = "l_shape";
    contours_ = {{0, 0}, {2, 2}, {7, 27}};
    hypotheses_.resize(objects * hypotheses);
    for (Hypothesis& hypothesis : hypotheses_) fill(hypothesis);
    for (std::size_t k = 0; k < objects; ++k) {
      const auto list = std::span(hypotheses_).subspan(k * hypotheses, hypotheses);
      objects_.push_back({{static_cast<int>(k), 20, 30, 40}, 5, judgement(list.size()), list});
    }
    if (!objects_.empty()) objects_.front().track = 7;
    recognition_.objects = objects_;
    recognition_.elapsed = std::chrono::nanoseconds(1900001);
    recognition_.stages.convert = std::chrono::nanoseconds(250000);
    recognition_.stages.match = std::chrono::nanoseconds(7);
  }

  std::string line(std::size_t bytes) const {
    // A canary shows writing beyond the end.
    std::vector<char> buffer(bytes + 8, '#');
    const FrameLabel label = {"frames/\xC3\xA4 \"1\".png", 12, 640, 480};
    const std::size_t length =
        write_recognition_json(label, recognition_, indexes_, std::span(buffer).first(bytes));
    REQUIRE(length <= bytes);
    REQUIRE(std::string(buffer.data() + bytes, 8) == "########");
    return {buffer.data(), length};
  }

  const Recognition& recognition() const { return recognition_; }
  LeftUndone& left_undone() { return recognition_.left_undone; }
  std::span<const ClassIndex> indexes() const { return indexes_; }

 private:
  static Judgement judgement(std::size_t hypotheses) {
    Judgement judgement{Verdict::ambiguous, 0.5F, {}, 0};
    if (hypotheses > 1) judgement.rivals[judgement.rival_count++] = 1;
    return judgement;
  }

  void fill(Hypothesis& hypothesis) {
    std::uniform_real_distribution<float> real(-1, 1);
    hypothesis.index = static_cast<std::uint16_t>(random_() % 2);
    hypothesis.class_id = static_cast<std::uint16_t>(random_() % 500);
    hypothesis.score = real(random_) * 1e6F;
    hypothesis.matched = static_cast<int>(random_() % 9);
    hypothesis.unmatched = static_cast<int>(random_() % 3);
    hypothesis.view = {real(random_), real(random_), real(random_)};
    hypothesis.contours = std::span(contours_).first(random_() % 4);
    pose_.refined.pose.translation = {0.1, -0.2, 1.5};
    pose_.refined.reprojection_px = 0.25F;
    for (std::size_t k = 0; k < 36; ++k)
      pose_.refined.covariance[k] = static_cast<double>(k) / 1000;
    if (random_() % 2 == 0) hypothesis.pose = &pose_;
  }

  std::mt19937 random_;
  VerifiedPose pose_;
  std::vector<ClassIndex> indexes_;
  std::vector<ContourMatch> contours_;
  std::vector<Hypothesis> hypotheses_;
  std::vector<SeenObject> objects_;
  Recognition recognition_;
};

std::size_t hypotheses_in(const json& line) {
  std::size_t count = 0;
  for (const json& object : line["objects"]) count += object["hypotheses"].size();
  return count;
}

TEST_CASE("A line of JSON holds what was recognised") {
  const MadeUp made_up(3, 4, 1);
  const std::string line = made_up.line(1 << 16);
  REQUIRE(line.find('\n') == line.size() - 1);
  const json parsed = json::parse(line);
  CHECK(parsed["frame"] == "frames/\xC3\xA4 \"1\".png");
  CHECK(parsed["sequence"] == 12);
  CHECK(parsed["width"] == 640);
  CHECK(parsed["height"] == 480);
  CHECK(parsed["elapsed_ms"] == 1.900001);
  CHECK(parsed["stages_ms"].size() == 6);
  CHECK(parsed["stages_ms"]["convert"] == 0.25);
  CHECK(parsed["stages_ms"]["match"] == 7e-6);
  CHECK_FALSE(parsed.contains("hypotheses_cut"));
  REQUIRE(parsed["objects"].size() == 3);
  CHECK(parsed["objects"][2]["box"] == json::array({2, 20, 30, 40}));
  CHECK(parsed["objects"][2]["regions"] == 5);
  // The first one is followed.
  CHECK(parsed["objects"][0]["track"] == 7);
  CHECK_FALSE(parsed["objects"][1].contains("track"));
}

TEST_CASE("What was left undone is told where there is something") {
  MadeUp made_up(3, 4, 1);
  CHECK_FALSE(json::parse(made_up.line(1 << 16)).contains("left_undone"));
  made_up.left_undone() = {2, 0, 31, 0, 0};
  CHECK(json::parse(made_up.line(1 << 16))["left_undone"] == json{{"objects", 2}, {"starts", 31}});
  made_up.left_undone() = {0, 5, 0, 4, 1};
  CHECK(json::parse(made_up.line(1 << 16))["left_undone"] ==
        json{{"indexes", 5}, {"tracks", 4}, {"searches", 1}});
}

TEST_CASE("Hypotheses read back as they were") {
  const MadeUp made_up(3, 4, 2);
  const json parsed = json::parse(made_up.line(1 << 16));
  for (std::size_t o = 0; o < 3; ++o) {
    for (std::size_t h = 0; h < 4; ++h) {
      const Hypothesis& truth = made_up.recognition().objects[o].hypotheses[h];
      const json& read = parsed["objects"][o]["hypotheses"][h];
      CHECK(read["object"] == made_up.indexes()[truth.index].object);
      CHECK(read["class"] == truth.class_id);
      CHECK(read["score"].get<double>() == truth.score);
      CHECK(read["matched"] == truth.matched);
      CHECK(read["unmatched"] == truth.unmatched);
      CHECK(read["view"].get<Vector3>() == truth.view);
      const json names = json::array({{0, "A"}, {2, "C"}, {7, "AB"}});
      REQUIRE(read["contours"].size() == truth.contours.size());
      for (std::size_t k = 0; k < truth.contours.size(); ++k)
        CHECK(read["contours"][k] == names[k]);
      REQUIRE(read.contains("pose") == (truth.pose != nullptr));
      if (truth.pose == nullptr) continue;
      const RefinedPose& pose = truth.pose->refined;
      CHECK(read["pose"]["quaternion"] == json::array({1.0, 0.0, 0.0, 0.0}));
      CHECK(read["pose"]["translation"].get<Vector3d>() == pose.pose.translation);
      CHECK(read["pose"]["reprojection_px"] == 0.25);
      CHECK(read["pose"]["covariance"].get<std::array<double, 36>>() == pose.covariance);
    }
  }
}

TEST_CASE("A verdict has its probability and its rivals, and is absent where there is none") {
  const json judged = json::parse(MadeUp(1, 2, 3).line(1 << 16))["objects"][0];
  CHECK(judged["verdict"] == "ambiguous");
  CHECK(judged["probability"] == 0.5);
  CHECK(judged["rivals"] == json::array({1}));
  const SeenObject silent;
  Recognition recognition;
  recognition.objects = std::span(&silent, 1);
  std::array<char, 4096> buffer;
  const std::size_t length = write_recognition_json({"f", 0, 1, 1}, recognition, {}, buffer);
  const json unjudged = json::parse(std::string(buffer.data(), length))["objects"][0];
  CHECK_FALSE(unjudged.contains("verdict"));
  CHECK_FALSE(unjudged.contains("probability"));
  CHECK_FALSE(unjudged.contains("rivals"));
}

TEST_CASE("Explanations stand with their objects") {
  const MadeUp made_up(3, 2, 4);
  std::vector<char> buffer(1 << 16);
  const std::vector<std::string> explanations = {"{\"of\":0}", "{\"of\":1}", "{\"of\":2}"};
  const std::size_t length = write_recognition_json({"f", 0, 1, 1}, made_up.recognition(),
                                                    made_up.indexes(), buffer, explanations);
  const json objects = json::parse(std::string(buffer.data(), length))["objects"];
  REQUIRE(objects.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(objects[k]["explanation"]["of"] == k);
    CHECK(objects[k]["hypotheses"].size() == 2);
  }
}

TEST_CASE("A frame in which nothing was seen has an empty list of objects") {
  const json parsed = json::parse(MadeUp(0, 0, 1).line(1 << 16));
  CHECK(parsed["objects"] == json::array());
}

TEST_CASE("An object that nothing fits has an empty list of hypotheses") {
  const json parsed = json::parse(MadeUp(2, 0, 1).line(1 << 16));
  REQUIRE(parsed["objects"].size() == 2);
  CHECK(parsed["objects"][0]["hypotheses"] == json::array());
}

// A line that fits and adds up; how many objects and hypotheses it shows.
std::pair<std::size_t, std::size_t> check_cut(const std::string& line, std::size_t objects,
                                              std::size_t hypotheses) {
  REQUIRE(line.back() == '\n');
  const json parsed = json::parse(line);
  const std::size_t shown = parsed["objects"].size(), listed = hypotheses_in(parsed);
  REQUIRE(shown + parsed.value("objects_cut", std::size_t{0}) == objects);
  REQUIRE(listed + parsed.value("hypotheses_cut", std::size_t{0}) == objects * hypotheses);
  if (hypotheses > 0)
    for (const json& object : parsed["objects"]) REQUIRE_FALSE(object["hypotheses"].empty());
  return {shown, listed};
}

TEST_CASE("A line is valid whatever the size of the buffer, and loses as little as can be") {
  for (const auto& [objects, hypotheses] :
       {std::pair<std::size_t, std::size_t>{3, 5}, {4, 1}, {1, 12}, {3, 0}, {0, 0}}) {
    const MadeUp made_up(objects, hypotheses, 3);
    const std::size_t whole = made_up.line(1 << 16).size();
    std::string before;
    std::pair<std::size_t, std::size_t> shown_before;
    std::size_t cuts = 0;
    for (std::size_t bytes = 0; bytes <= whole; ++bytes) {
      const std::string line = made_up.line(bytes);
      if (line == before) continue;
      // The next longer line appears as soon as there is room for it.
      REQUIRE(line.size() == bytes);
      const auto shown = check_cut(line, objects, hypotheses);
      if (cuts > 0) REQUIRE(shown > shown_before);
      shown_before = shown;
      before = line;
      ++cuts;
    }
    REQUIRE(before.size() == whole);
    CHECK(cuts == objects + std::max(hypotheses, std::size_t{1}));
  }
}

TEST_CASE("Writing a line allocates nothing") {
  const MadeUp made_up(8, 10, 4);
  std::vector<char> buffer(1 << 16);
  const FrameLabel label = {"camera", 1, 640, 480};
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{900}, buffer.size()}) {
    const std::size_t before = allocation_count();
    write_recognition_json(label, made_up.recognition(), made_up.indexes(),
                           std::span(buffer).first(bytes));
    REQUIRE(allocation_count() == before);
  }
}

TEST_CASE("Contours are named A to Z, then AA, AB and so on") {
  const auto name_of = [](std::uint16_t place) {
    char buffer[4];
    return std::string(contour_name(place, buffer));
  };
  CHECK(name_of(0) == "A");
  CHECK(name_of(25) == "Z");
  CHECK(name_of(26) == "AA");
  CHECK(name_of(27) == "AB");
  CHECK(name_of(51) == "AZ");
  CHECK(name_of(701) == "ZZ");
  CHECK(name_of(702) == "AAA");
  CHECK(name_of(65535) == "CRXP");
}

}  // namespace
}  // namespace aspect
