// Indexes for other sensors than colour, from the scene to the recognised frame.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <sstream>

#include "runtime/recognition/class_index.h"
#include "schema/class_index_generated.h"
#include "tests/temporary_folder.h"
#include "tests/tools/aspectc/run_aspectc.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using nlohmann::json;

// A white L, in small pictures: nothing but its shape tells its views apart.
constexpr const char* kScene = R"(
studio { at 0 0 0 up 0 0 1 angle 50 resolution 192 192 antialias none threshold 1 aspect 1
         ambient 1 1 1 }
surface { diffuse .8 .8 .8 }
polygon { points 6 vertex -.2 -.15 -.25 vertex .2 -.15 -.25 vertex .2 -.15 -.1
                   vertex -.05 -.15 -.1 vertex -.05 -.15 .25 vertex -.2 -.15 .25 }
polygon { points 6 vertex -.2 .15 -.25 vertex .2 .15 -.25 vertex .2 .15 -.1
                   vertex -.05 .15 -.1 vertex -.05 .15 .25 vertex -.2 .15 .25 }
polygon { points 4 vertex -.2 -.15 -.25 vertex .2 -.15 -.25 vertex .2 .15 -.25 vertex -.2 .15 -.25 }
polygon { points 4 vertex .2 -.15 -.25 vertex .2 -.15 -.1 vertex .2 .15 -.1 vertex .2 .15 -.25 }
polygon { points 4 vertex .2 -.15 -.1 vertex -.05 -.15 -.1 vertex -.05 .15 -.1 vertex .2 .15 -.1 }
polygon { points 4 vertex -.05 -.15 -.1 vertex -.05 -.15 .25 vertex -.05 .15 .25
                   vertex -.05 .15 -.1 }
polygon { points 4 vertex -.05 -.15 .25 vertex -.2 -.15 .25 vertex -.2 .15 .25 vertex -.05 .15 .25 }
polygon { points 4 vertex -.2 -.15 .25 vertex -.2 -.15 -.25 vertex -.2 .15 -.25 vertex -.2 .15 .25 }
)";

class Workplace {
 public:
  Workplace() { folder_.write("part.b", kScene); }
  Outcome run(const std::vector<std::string>& arguments) const {
    return run_aspectc(folder_.path(), arguments);
  }
  Outcome replay(const std::string& arguments) const {
    return run_shell(folder_.path(), "'" ASPECT_REPLAY "' " + arguments);
  }
  fs::path file(const std::string& name) const { return folder_.path() / name; }

  void compile(const std::string& sensor) const {
    const Outcome outcome =
        run({"part.b", "--sensor", sensor, "--level", "3", "--no-store", "-o", sensor + ".aspect"});
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    // Range indexes have no golden frame, and it is said.
    CHECK((outcome.err.find("golden frame") != std::string::npos) == (sensor == "range"));
  }

 private:
  TemporaryFolder folder_;
};

// One place with both indexes, for all tests that only read them.
const Workplace& compiled_workplace() {
  static const Workplace workplace;
  static const bool compiled = (workplace.compile("range"), workplace.compile("surface"), true);
  REQUIRE(compiled);
  return workplace;
}

using Direction = std::array<double, 3>;

Direction random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Direction d{};
  for (double& x : d) x = normal(random);
  const double length = std::hypot(d[0], d[1], d[2]);
  for (double& x : d) x /= length;
  return d;
}

std::string words_of(const Direction& d) {
  return std::to_string(d[0]) + "," + std::to_string(d[1]) + "," + std::to_string(d[2]);
}

double angle_deg(const Direction& a, const json& b) {
  double cosine = 0;
  for (std::size_t k = 0; k < 3; ++k) cosine += a[k] * b[k].get<double>();
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
}

bool is_one_line(const std::string& text) {
  return text.find('\n') == text.size() - 1;
}

}  // namespace

TEST_CASE("recorded range frames tell from where a shape without colours is seen") {
  constexpr int kFrames = 30;
  const Workplace& here = compiled_workplace();
  std::mt19937 random(12);
  std::vector<Direction> truth;
  fs::create_directory(here.file("frames"));
  for (int k = 0; k < kFrames; ++k) {
    truth.push_back(random_direction(random));
    REQUIRE(here.run({"render", "part.b", "--sensor", "range", "--from=" + words_of(truth.back()),
                      "-o", "frames/" + std::to_string(100 + k) + ".png"})
                .exit_code == 0);
  }
  const Outcome outcome = here.replay("--index range.aspect frames");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  std::istringstream lines(outcome.out);
  int near = 0;
  for (const Direction& direction : truth) {
    std::string line;
    REQUIRE(std::getline(lines, line));
    const json objects = json::parse(line)["objects"];
    if (objects.empty() || objects[0]["hypotheses"].empty()) continue;
    near += angle_deg(direction, objects[0]["hypotheses"][0]["view"]) <= 20 ? 1 : 0;
  }
  CAPTURE(near);
  CHECK(near >= kFrames * 8 / 10);
}

TEST_CASE("every sensor's index says what it is of, and the surface index knows its surfaces") {
  const Workplace& here = compiled_workplace();
  for (const std::string sensor : {"range", "surface"}) {
    const ClassIndex index = load_index(here.file(sensor + ".aspect")).value();
    CHECK(name_of(index.vision.sensor) == sensor);
    CHECK(index.classes.size() > 5);
    CHECK_THAT(here.run({"inspect", sensor + ".aspect"}).out, Contains("seen in " + sensor));
  }
  const ClassIndex range = load_index(here.file("range.aspect")).value();
  CHECK(range.vision.range.field_of_view_deg == 50);
  CHECK(range.vision.range.depth_step == RangeParameters{}.depth_step);
}

TEST_CASE("frames and indexes of different sensors are refused in one line") {
  const Workplace& here = compiled_workplace();
  REQUIRE(here.run({"render", "part.b", "--from", "1,2,3", "-o", "colour.png"}).exit_code == 0);
  REQUIRE(here.run({"render", "part.b", "--from", "1,2,3", "--sensor", "range", "-o", "depth.png"})
              .exit_code == 0);
  const Outcome frame = here.replay("--index range.aspect colour.png");
  CHECK(frame.exit_code == 1);
  CHECK(frame.out.empty());
  CHECK(is_one_line(frame.err));
  CHECK_THAT(frame.err, Contains("colour.png: not a range frame"));
  const Outcome indexes = here.replay("--index range.aspect --index surface.aspect depth.png");
  CHECK(indexes.exit_code == 1);
  CHECK(is_one_line(indexes.err));
  CHECK_THAT(indexes.err, Contains("surface.aspect: "));
  CHECK(here.replay("--index range.aspect depth.png").exit_code == 0);
}

TEST_CASE("replay tests indexes with their golden frames, one line each") {
  const Workplace& here = compiled_workplace();
  const Outcome passed = here.replay("--index surface.aspect --self-test");
  INFO(passed.err);
  CHECK(passed.exit_code == 0);
  CHECK(is_one_line(passed.out));
  CHECK_THAT(passed.out, Contains("part: self test: passed"));
  const Outcome none = here.replay("--self-test --index range.aspect");
  CHECK(none.exit_code == 0);
  CHECK(is_one_line(none.out));
  CHECK_THAT(none.out, Contains("no golden frame"));
}

TEST_CASE("replay ends with exit code 1 where a golden frame gets another answer") {
  const Workplace& here = compiled_workplace();
  std::string bytes = read_file(here.file("surface.aspect"));
  auto* root = flatbuffers::GetMutableRoot<schema::ClassIndex>(bytes.data());
  auto* golden =
      reinterpret_cast<flatbuffers::Table*>(const_cast<schema::GoldenFrame*>(root->golden_frame()));
  const std::uint16_t other = root->golden_frame()->class_id() == 0 ? 1 : 0;
  REQUIRE(golden->SetField(schema::GoldenFrame::VT_CLASS_ID, other, std::uint16_t{0}));
  const auto* field = reinterpret_cast<const flatbuffers::Table*>(root)->GetAddressOf(
      schema::ClassIndex::VT_CHECKSUM);
  const auto place =
      static_cast<std::size_t>(field - reinterpret_cast<const std::uint8_t*>(bytes.data()));
  const std::uint64_t sum = index_checksum(std::as_bytes(std::span(bytes)), place);
  std::memcpy(bytes.data() + place, &sum, sizeof sum);
  std::ofstream(here.file("wrong.aspect"), std::ios::binary) << bytes;
  const Outcome failed = here.replay("--index wrong.aspect --self-test");
  CHECK(failed.exit_code == 1);
  CHECK(failed.out.empty());
  CHECK(is_one_line(failed.err));
  CHECK_THAT(failed.err, Contains("part: self test: failed") && Contains("was found") &&
                             Contains("copy both again"));
}

TEST_CASE("a store of another sensor is refused, and a sensor that there is not") {
  const Workplace here;
  REQUIRE(here.run({"part.b", "--level", "3", "--sensor", "surface"}).exit_code == 0);
  const Outcome other = here.run({"part.b", "--level", "3", "--sensor", "range"});
  CHECK(other.exit_code == 1);
  CHECK_THAT(other.err, Contains("part.store") && Contains("other options"));
  CHECK(here.run({"part.b", "--level", "3", "--sensor", "surface"}).exit_code == 0);
  CHECK(here.run({"part.b", "--sensor", "sonar"}).exit_code == 2);
}

}  // namespace aspect
