// aspect-eval as its users start it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>

#include "tests/child_program.h"
#include "tests/temporary_folder.h"
#include "tests/tools/plot/drawn_svg.h"
#include "tools/score/truth_table.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

const std::string kCube =
    " --index cube.aspect --scene '" ASPECT_SOURCE_DIR "/tests/data/rendered/cube.b' ";
const std::string kMisfit =
    " --index cube.aspect --scene '" ASPECT_SOURCE_DIR "/tests/data/rendered/l_shape.b' ";

// A folder with an index of the cube, compiled once for all tests.
const TemporaryFolder& folder_of_cube() {
  static const TemporaryFolder folder;
  static const Outcome compiled =
      run_shell(folder.path(), "'" ASPECT_ASPECTC "' '" ASPECT_SOURCE_DIR
                               "/tests/data/rendered/cube.b' -o cube.aspect --level 2 "
                               "--min-level 2 --no-store --progress never");
  REQUIRE(compiled.exit_code == 0);
  return folder;
}

class Evaluations {
 public:
  Evaluations() { std::filesystem::copy(folder_of_cube().path(), path()); }
  void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }
  const std::filesystem::path& path() const { return folder_.path(); }
  Outcome compile(const std::string& arguments) const {
    return run("'" ASPECT_ASPECTC "' " + arguments);
  }
  Outcome eval(const std::string& arguments) const { return run("'" ASPECT_EVAL "' " + arguments); }

 private:
  Outcome run(const std::string& command) const { return run_shell(folder_.path(), command); }
  TemporaryFolder folder_;
};

TEST_CASE("A table is printed, or one JSON object") {
  const Evaluations evaluations;
  const Outcome table = evaluations.eval(kCube + "--views 10");
  CHECK(table.exit_code == 0);
  CHECK(table.err == "");
  CHECK_THAT(table.out, StartsWith("10 random views an object, seed 1") && Contains("cube"));
  const Outcome json = evaluations.eval(kCube + "--views 10 --seed 5 --ranking classes --json");
  CHECK(json.exit_code == 0);
  const auto parsed = nlohmann::json::parse(json.out);
  CHECK(parsed["seed"] == 5);
  CHECK(parsed["ranking"] == "classes");
  CHECK(parsed["objects"][0]["views"].size() == 10);
  CHECK(parsed["objects"][0]["pose"].is_null());
  CHECK(parsed["objects"][0]["reliability"]["not_judged"] == 10);
  CHECK_FALSE(parsed.contains("confusion"));
}

TEST_CASE("A file of several indexes takes a scene or a project for each of its objects") {
  const Evaluations evaluations;
  evaluations.write("two.toml",
                    "[subdivision]\nlevel = 1\nmin_level = 1\n"
                    "[[object]]\nscene = \"" ASPECT_SOURCE_DIR
                    "/tests/data/rendered/cube.b\"\n"
                    "[[object]]\nname = \"far\"\nscene = \"" ASPECT_SOURCE_DIR
                    "/tests/data/rendered/cube.b\"\n[object.camera]\ndistance = [1, 1.4]\n");
  evaluations.write("far.toml", "name = \"far\"\nscene = \"" ASPECT_SOURCE_DIR
                                "/tests/data/rendered/cube.b\"\n[camera]\ndistance = [1, 1.4]\n");
  REQUIRE(evaluations.compile("two.toml --combined true --no-store").exit_code == 0);
  const std::string cube = " --scene '" ASPECT_SOURCE_DIR "/tests/data/rendered/cube.b'";
  const Outcome outcome =
      evaluations.eval("--index two.aspect" + cube + " --scene far.toml --views 3 --json");
  CHECK(outcome.err == "");
  REQUIRE(outcome.exit_code == 0);
  const auto parsed = nlohmann::json::parse(outcome.out);
  REQUIRE(parsed["objects"].size() == 2);
  CHECK(parsed["objects"][1]["object"] == "far");
  CHECK(evaluations.eval("--index two.aspect" + cube).exit_code == 2);
}

TEST_CASE("A reliability plot is written whole, or the run ends before it begins") {
  const Evaluations evaluations;
  const Outcome outcome = evaluations.eval(kCube + "--views 5 --reliability plot.svg");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err == "");
  CHECK_THAT(outcome.out, Contains("calibration error"));
  const std::string svg = read_file(evaluations.path() / "plot.svg");
  CHECK_THAT(svg, StartsWith("<svg ") && Catch::Matchers::EndsWith("</svg>\n"));
  CHECK_THAT(svg, Contains("5 views judged"));

  const Outcome nowhere = evaluations.eval(kCube + "--views 5 --reliability none/plot.svg");
  CHECK(nowhere.exit_code == 1);
  CHECK(nowhere.out == "");
  CHECK_THAT(nowhere.err, StartsWith("aspect-eval: none/plot.svg: cannot be written ("));
  for (const auto& entry : std::filesystem::directory_iterator(evaluations.path()))
    CHECK(entry.path().extension() != ".part");
}

TEST_CASE("All plots are written to a folder that need not be there") {
  const Evaluations evaluations;
  evaluations.write("ranks.csv", "object,top1,top2\nCUBE,40,60\n");
  const Outcome outcome =
      evaluations.eval(kCube + "--views 5 --plots made/plots --thesis-ranks ranks.csv");
  CHECK(outcome.err == "");
  CHECK(outcome.exit_code == 0);
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(evaluations.path() / "made/plots"))
    names.insert(entry.path().filename());
  CHECK(names == std::set<std::string>{"rank.svg", "pose_error.svg", "reliability.svg"});
  const auto drawn = drawn_svg(read_file(evaluations.path() / "made/plots/rank.svg"));
  CHECK(drawn["curves"].size() == 3);
  for (const std::string& arguments :
       {std::string("--plots cube.aspect/x"), std::string("--plots p --thesis-ranks none.csv"),
        std::string("--plots p --thesis-ranks cube.aspect")}) {
    const Outcome refused = evaluations.eval(kCube + "--views 5 " + arguments);
    CHECK(refused.exit_code == 1);
    CHECK(refused.out == "");
    CHECK(std::count(refused.err.begin(), refused.err.end(), '\n') == 1);
  }
  CHECK(evaluations.eval(kCube + "--views 5 --thesis-ranks ranks.csv").exit_code == 2);
}

TEST_CASE("Frames in clutter are measured, and written with their truth") {
  const Evaluations evaluations;
  const Outcome outcome = evaluations.eval(
      kCube + "--clutter --views 8 --json --dump frames --recall recall.svg --plots plots");
  CHECK(outcome.err == "");
  REQUIRE(outcome.exit_code == 0);
  const auto parsed = nlohmann::json::parse(outcome.out);
  const auto& clutter = parsed["objects"][0]["clutter"];
  CHECK(parsed["views"] == 8);
  CHECK(clutter["frames_with_object"] == 6);
  CHECK(clutter["frames_without"] == 2);
  const auto truth = read_truth(evaluations.path() / "frames/truth.csv");
  REQUIRE(truth.ok());
  REQUIRE(truth.value().size() == 8);
  for (std::size_t k = 0; k < 8; ++k) {
    const TrueFrame& frame = truth.value()[k];
    CHECK(frame.objects.empty() == (k % 4 == 3));
    CHECK(cv::imread((evaluations.path() / "frames" / frame.file).native()).cols == 512);
    if (frame.objects.empty()) continue;
    CHECK(frame.objects[0].visible ==
          Approx(clutter["frames"][k]["visible"].get<double>()).margin(1e-4));
  }
  CHECK_THAT(read_file(evaluations.path() / "recall.svg"), Contains("8 frames in clutter"));
  CHECK(read_file(evaluations.path() / "plots/recall.svg") ==
        read_file(evaluations.path() / "recall.svg"));
  CHECK(drawn_svg(read_file(evaluations.path() / "plots/pose_error.svg"))["outside"].empty());
  CHECK_THAT(evaluations.eval(kCube + "--clutter --views 4 --backgrounds frames").out,
             Contains("before pieces of 8 pictures of frames"));
}

TEST_CASE("An index that does not belong to the scene gets a warning") {
  const Outcome outcome = Evaluations().eval(kMisfit + "--views 2");
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.err, StartsWith("aspect-eval: warning: cube.aspect: "));
}

TEST_CASE("Wrong usage and bad files are told in one line") {
  const Evaluations evaluations;
  for (const std::string& arguments :
       {std::string(), std::string("--index cube.aspect"), kCube + "--scene x.b",
        kCube + "--views 0", kCube + "--views x", kCube + "--seed -1", kCube + "--ranking best",
        kCube + "--hidden 0.3", kCube + "--clutter --reliability x.svg",
        kCube + "--reliability x.svg --ranking classes", kCube + "--bogus", kCube + "more"}) {
    const Outcome outcome = evaluations.eval(arguments);
    INFO(arguments);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out == "");
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
  for (const std::string& arguments :
       {std::string("--index none.aspect --scene none.b"),
        std::string("--index cube.aspect --scene none.b"), kCube + kCube,
        kCube + "--clutter --backgrounds none", kCube + "--clutter --dump cube.aspect/x"}) {
    const Outcome outcome = evaluations.eval(arguments);
    INFO(arguments);
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.out == "");
    CHECK_THAT(outcome.err, StartsWith("aspect-eval: "));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
  CHECK(evaluations.eval("--help").exit_code == 0);
  CHECK_THAT(evaluations.eval("--version").out, StartsWith("aspect-eval "));
}

}  // namespace
}  // namespace aspect
