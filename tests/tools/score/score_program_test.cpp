// aspect-score as its users start it, and against the script that its rules come from.
#include <fmt/format.h>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <random>
#include <sstream>

#include "tests/child_program.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using nlohmann::json;

const std::string kHead =
    "file,object,r00,r01,r02,r10,r11,r12,r20,r21,r22,tx,ty,tz,vx,vy,vz,x,y,w,h,visible\n";
const std::string kPose = "1,0,0,0,1,0,0,0,1,0,0,1,";

class Scores {
 public:
  Scores() {
    folder_.write("truth.csv", kHead + "frames/0.png,cube," + kPose +
                                   "1,0,0,10,10,100,100,1\nframes/1.png,ball," + kPose +
                                   "0,0,1,10,10,100,100,1\n");
    folder_.write("seen.ndjson", line("frames/0.png", 0, "cube", "[0.8,0.6,0]") +
                                     line("frames/1.png", 1, "cube", "[0,0,1]"));
  }

  static std::string line(const std::string& frame, int sequence, const std::string& object,
                          const std::string& view) {
    return fmt::format(
        R"({{"frame":"{}","sequence":{},"elapsed_ms":{}.5,"objects":[{{"box":[10,10,100,100],)"
        R"("hypotheses":[{{"object":"{}","view":{}}}]}}]}})"
        "\n",
        frame, sequence, sequence, object, view);
  }

  Outcome run(const std::string& command) const { return run_shell(folder_.path(), command); }
  Outcome score(const std::string& arguments) const {
    return run("'" ASPECT_SCORE "' " + arguments);
  }
  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

TEST_CASE("The summary and the table are aligned") {
  const Scores scores;
  const Outcome outcome = scores.score("truth.csv seen.ndjson --table");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err == "");
  CHECK(outcome.out ==
        "frame         true  found  error deg    ms\n"
        "frames/0.png  cube  cube       36.87  0.50\n"
        "frames/1.png  ball  cube           -  1.50\n"
        "\n"
        "object  number  right %  median deg  <= 5 %  <= 10 %  <= 20 %  median ms\n"
        "ball         1      0.0      180.00     0.0      0.0      0.0       1.50\n"
        "cube         1    100.0       36.87     0.0      0.0      0.0       0.50\n"
        "all          2     50.0      108.43     0.0      0.0      0.0       1.00\n"
        "2 frames, 0 missing, 1 things named where they are not\n");
}

TEST_CASE("--json says what the table says, with the same exit code") {
  const Scores scores;
  const Outcome outcome = scores.score("truth.csv seen.ndjson --table --json --min-right 60");
  CHECK(outcome.exit_code == 1);
  const json score = json::parse(outcome.out);
  const json& ball = score["objects"][0];
  CHECK(ball == json{{"object", "ball"},
                     {"number", 1},
                     {"right_percent", 0.0},
                     {"median_deg", 180.0},
                     {"within_5_percent", 0.0},
                     {"within_10_percent", 0.0},
                     {"within_20_percent", 0.0},
                     {"median_ms", 1.5}});
  CHECK(score["objects"][1]["median_deg"].get<double>() == Approx(36.87).margin(0.005));
  CHECK(score["all"]["right_percent"] == 50.0);
  CHECK(score["all"]["median_deg"].get<double>() == Approx(108.43).margin(0.005));
  CHECK(score["frames"] == 2);
  CHECK(score["missing"] == 0);
  CHECK(score["falsely_named"] == 1);
  CHECK(score["table"][1] == json{{"frame", "frames/1.png"},
                                  {"missing", false},
                                  {"ms", 1.5},
                                  {"objects",
                                   {{{"true", "ball"},
                                     {"found", "cube"},
                                     {"counts", true},
                                     {"right", false},
                                     {"error_deg", nullptr}}}}});
  CHECK_FALSE(json::parse(scores.score("truth.csv seen.ndjson --json").out).contains("table"));
}

TEST_CASE("Demands that are missed and frames that are missing fail") {
  const Scores scores;
  CHECK(scores.score("truth.csv seen.ndjson --min-right 50 --max-median 109 --min-within20 0")
            .exit_code == 0);
  for (const char* demand : {"--min-right 50.1", "--max-median 108", "--min-within20 1"}) {
    const Outcome missed = scores.score("truth.csv seen.ndjson " + std::string(demand));
    INFO(demand);
    CHECK(missed.exit_code == 1);
    CHECK_THAT(missed.err, StartsWith("aspect-score: seen.ndjson: ") && Contains("demanded"));
    CHECK(std::count(missed.err.begin(), missed.err.end(), '\n') == 1);
  }
  scores.folder().write("one.ndjson", Scores::line("frames/1.png", 1, "ball", "[0,0,1]"));
  const Outcome missing = scores.score("truth.csv one.ndjson --table");
  CHECK(missing.exit_code == 1);
  CHECK_THAT(missing.out, Contains("frames/0.png  cube  (missing)"));
  CHECK_THAT(missing.err, Contains("no line for the frame frames/0.png"));

  scores.folder().write("empty.csv", kHead + "frames/0.png" + std::string(21, ',') + "\n");
  CHECK(scores.score("empty.csv seen.ndjson").exit_code == 0);
  CHECK(scores.score("empty.csv seen.ndjson --min-right 1").exit_code == 1);
  CHECK(scores.score("empty.csv seen.ndjson --max-median 20").exit_code == 1);
}

TEST_CASE("Wrong usage and bad files are told in one line") {
  const Scores scores;
  for (const char* arguments :
       {"", "truth.csv", "truth.csv seen.ndjson more", "truth.csv seen.ndjson --min-right 101",
        "truth.csv seen.ndjson --min-right nan", "truth.csv seen.ndjson --sheet s.png",
        "truth.csv seen.ndjson --overlays .", "--bogus"}) {
    const Outcome outcome = scores.score(arguments);
    INFO(arguments);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out == "");
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
  for (const char* arguments : {"none.csv seen.ndjson", "truth.csv none", "truth.csv truth.csv",
                                "truth.csv seen.ndjson --symmetries none.csv"}) {
    const Outcome outcome = scores.score(arguments);
    INFO(arguments);
    CHECK(outcome.exit_code == 1);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
  CHECK(scores.score("--help").exit_code == 0);
  CHECK_THAT(scores.score("--version").out, StartsWith("aspect-score "));
}

TEST_CASE("A sheet of the overlays is written") {
  const Scores scores;
  const cv::Mat overlay(50, 100, CV_8UC3, cv::Scalar(200, 100, 50));
  scores.folder().write("drawn/none", "");
  cv::imwrite((scores.folder().path() / "drawn/000000_0.png").native(), overlay);
  const std::string arguments = "truth.csv seen.ndjson --sheet s.png --overlays drawn";
  const Outcome without = scores.score(arguments);
  CHECK(without.exit_code == 1);
  CHECK_THAT(without.err, Contains("000001_1.png: no such picture"));
  cv::imwrite((scores.folder().path() / "drawn/000001_1.png").native(), overlay);
  CHECK(scores.score(arguments).exit_code == 0);
  CHECK(cv::imread((scores.folder().path() / "s.png").native()).cols > 2 * 420);
  CHECK_THAT(scores.score("truth.csv seen.ndjson --sheet no/s.png --overlays drawn").err,
             Contains("no/s.png: cannot be written"));
}

// Random frames of up to three objects, some hidden; things that are seen or not, under a right or
// a wrong name, shifted, with and without a verdict.
struct RandomCase {
  std::string truth = kHead, results;
  std::mt19937 random{7};
  int below(int end) { return static_cast<int>(random() % static_cast<unsigned>(end)); }

  std::array<double, 3> unit() {
    for (;;) {
      const std::array<double, 3> v{below(201) - 100.0, below(201) - 100.0, below(201) - 100.0};
      const double length = std::hypot(v[0], v[1], v[2]);
      if (length > 1) return {v[0] / length, v[1] / length, v[2] / length};
    }
  }

  void add_frame(int number) {
    const std::array<const char*, 3> names = {"cube", "blockcyl1", "pegblock"};
    const std::array<const char*, 3> shares = {"1", "0.7", "0.5"};
    const std::array<const char*, 4> verdicts = {"", "match", "ambiguous", "unknown"};
    json objects = json::array();
    const std::string file = fmt::format("frames/{:03}.png", number);
    const int count = below(4);
    if (count == 0) truth += file + std::string(21, ',') + "\n";
    for (int k = 0; k < count; ++k) {
      const std::string name = names[static_cast<std::size_t>(below(3))];
      const std::array<double, 3> v = unit();
      const char* visible = shares[static_cast<std::size_t>(below(8)) / 3];
      truth += fmt::format("{},{},{}{:.9f},{:.9f},{:.9f},{},20,100,100,{}\n", file, name, kPose,
                           v[0], v[1], v[2], 120 * k, visible);
      if (below(8) == 0) continue;
      const std::array<double, 3> far = unit();
      json view = json::array();
      const double share = 0.2 * below(3);
      for (std::size_t axis = 0; axis < 3; ++axis) view.push_back(v[axis] + share * far[axis]);
      json object;
      object["box"] = {120 * k + below(60), 20 + below(40), 100, 100};
      object["hypotheses"] = json::array();
      object["hypotheses"].push_back({{"object", below(6) == 0 ? "cube" : name}, {"view", view}});
      const std::string verdict = verdicts[static_cast<std::size_t>(below(8)) % 4];
      if (!verdict.empty()) object["verdict"] = verdict;
      objects.push_back(object);
    }
    results += json{{"frame", "elsewhere/" + file},
                    {"sequence", number},
                    {"elapsed_ms", 1 + 0.01 * below(300)},
                    {"objects", objects}}
                   .dump() +
               "\n";
  }
};

std::optional<fs::path> shared_score_script() {
  const char* named = std::getenv("ASPECT_SHARED");
  const fs::path shared =
      named != nullptr ? fs::path(named) : fs::path(ASPECT_SOURCE_DIR "/../shared");
  const fs::path script = shared / "cases/tools/score.py";
  if (!fs::exists(script) || std::system("/usr/bin/python3 -c 'import numpy' 2>/dev/null") != 0)
    return std::nullopt;
  return script;
}

TEST_CASE("The figures are those of score.py, to the printed digit") {
  const auto script = shared_score_script();
  if (!script) {
    WARN("skipped: needs /usr/bin/python3 with numpy, and score.py in $ASPECT_SHARED/cases/tools");
    return;
  }
  RandomCase random;
  for (int number = 0; number < 57; ++number) random.add_frame(number);
  const Scores scores;
  scores.folder().write("random.csv", random.truth);
  scores.folder().write("random.ndjson", random.results);
  scores.folder().write("symmetries.csv", "blockcyl1,0,1,0,180\n");
  const Outcome theirs =
      scores.run("/usr/bin/python3 '" + script->native() + "' random.csv random.ndjson");
  REQUIRE(theirs.exit_code == 0);
  const Outcome ours = scores.score("random.csv random.ndjson --symmetries symmetries.csv");
  REQUIRE(ours.exit_code == 0);

  const json expected = json::parse(theirs.out);
  CHECK(expected.at("all").at("recall").get<double>() > 0.2);
  CHECK(expected.at("all").at("recall").get<double>() < 0.9);
  std::istringstream lines(ours.out);
  std::string line;
  std::getline(lines, line);
  std::size_t compared = 0;
  for (; compared < expected.size() && std::getline(lines, line); ++compared) {
    std::istringstream cells(line);
    std::string name, objects, right, median, w5, w10, w20, ms;
    cells >> name >> objects >> right >> median >> w5 >> w10 >> w20 >> ms;
    INFO(line);
    const json& all = expected.at(name);
    const auto percent = [&](const char* key) {
      return fmt::format("{:.1f}", 100 * all.at(key).get<double>());
    };
    CHECK(objects == fmt::format("{}", all.at("objects").get<int>()));
    CHECK(right == percent("recall"));
    CHECK(median == fmt::format("{:.2f}", all.at("view_median_deg").get<double>()));
    CHECK(w5 == percent("view_within5"));
    CHECK(w10 == percent("view_within10"));
    CHECK(w20 == percent("view_within20"));
    if (name == "all") CHECK(ms == fmt::format("{:.2f}", all.at("ms_median").get<double>()));
  }
  CHECK(compared == expected.size());
  const double false_per_frame = expected.at("all").at("false_per_frame").get<double>();
  CHECK_THAT(ours.out, Contains(fmt::format("{} things named where they are not",
                                            std::lround(57 * false_per_frame))));
}

}  // namespace
}  // namespace aspect
