// aspectc doctor as its users start it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <tuple>

#include "tests/temporary_folder.h"
#include "tests/tools/aspectc/run_aspectc.h"
#include "tests/tools/doctor/sick_meshes.h"
#include "tools/doctor/repair.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Codes = std::set<std::string>;
using Json = nlohmann::json;

Codes codes_in(const Json& object) {
  Codes codes;
  for (const Json& finding : object["findings"])
    if (finding["severity"] != "note") codes.insert(finding["code"].get<std::string>());
  return codes;
}

struct Examined {
  int exit_code = 0;
  Json json;

  Codes codes() const { return codes_in(json["objects"][0]); }
  Codes left() const { return codes_in(json["fix"]["left"]); }
};

Examined examine(const fs::path& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "doctor");
  arguments.emplace_back("--json");
  const Outcome outcome = run_aspectc(folder, arguments);
  INFO(outcome.err);
  REQUIRE_FALSE(outcome.out.empty());
  return {outcome.exit_code, Json::parse(outcome.out)};
}

void check_refused(const Outcome& outcome, int exit_code, const std::string& part) {
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == exit_code);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.err, Catch::StartsWith("aspectc: ") && Catch::Contains(part));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
}

ColouredMesh sick_cuboid() {
  ColouredMesh mesh = cuboid({-40, -30, -20}, {40, 30, 20});
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  repeat_triangle(mesh, 7);
  repeat_triangle(mesh, 9);
  mesh.triangles.back()[1] = mesh.triangles.back()[0];
  for (const std::size_t k : {4U, 5U}) mesh.colours[k] = {.84, .11, .1};  // +x: .1 .75 .15
  for (const std::size_t k : {2U, 3U}) mesh.colours[k] = {.85, .1, .1};
  return mesh;
}

}  // namespace

TEST_CASE("the models of the tree are free of errors, and healthy but for the L of the thesis") {
  const fs::path models = fs::path(ASPECT_SOURCE_DIR) / "compiler/models";
  const TemporaryFolder folder;
  std::size_t seen = 0;
  for (const auto& entry : fs::directory_iterator(models)) {
    if (entry.path().extension() != ".b") continue;
    ++seen;
    const Examined examined = examine(folder.path(), {entry.path().string()});
    CAPTURE(entry.path());
    CHECK(examined.json["objects"][0]["errors"] == 0);
    // Its colours are those of the real object, of which some are alike.
    const bool alike = entry.path().stem() == "l_shape";
    CHECK(examined.codes() == (alike ? Codes{"too_many_colours", "inseparable_colours"} : Codes{}));
    CHECK(examined.exit_code == (alike ? 1 : 0));
  }
  CHECK(seen == 10);
}

TEST_CASE("what --fix says is fixed is not found in what it wrote") {
  const TemporaryFolder folder;
  folder.write("sick.ply", ply_text(sick_cuboid()));
  const Codes all = {"flipped_faces", "duplicate_faces", "zero_area_faces", "inseparable_colours",
                     "too_many_colours"};
  for (const char* output : {"healed.b", "healed.ply"}) {
    CAPTURE(output);
    const Examined examined = examine(folder.path(), {"sick.ply", "--fix", output});
    CHECK(examined.codes() == all);
    CHECK(examined.left().empty());
    CHECK(examined.exit_code == 0);
    REQUIRE(examined.json["fix"]["colours"].size() == 1);
    CHECK(examined.json["fix"]["colours"][0]["separation_after"].get<double>() > 1);
    const Examined again = examine(folder.path(), {output});
    CHECK(again.codes().empty());
    CHECK(again.exit_code == 0);
  }
}

TEST_CASE("a hole is reported and left, in an OBJ file too") {
  const TemporaryFolder folder;
  ColouredMesh mesh = dented_ball(4);
  for (int k = 0; k < 5; ++k) erase_triangle(mesh, 40);
  folder.write("ball.obj", obj_text(mesh));
  const Examined examined = examine(folder.path(), {"ball.obj", "--fix", "out.b"});
  CHECK(examined.codes() == Codes{"open_edges"});
  CHECK(examined.left().contains("open_edges"));
  CHECK(examined.exit_code == 1);
  for (const Json& finding : examined.json["objects"][0]["findings"])
    if (finding["code"] == "open_edges") CHECK(finding["count"] == plain_open_edges(mesh));
  erase_triangle(mesh, 0);
  folder.write("whole.obj", obj_text(dented_ball(4)));
  CHECK(examine(folder.path(), {"whole.obj"}).exit_code == 0);
}

TEST_CASE("a Bob scene off centre, too large and with a repeated face is put right") {
  const TemporaryFolder folder;
  folder.write("part.b",
               "studio { angle 50 resolution 256 256 ambient 1 1 1 }\n"
               "surface { diffuse .8 .1 .1 } sphere { center 3 0 0 radius 1 }\n"
               "surface { diffuse .1 .8 .1 }\n"
               "polygon { points 3 vertex 3 2 0 vertex 4 3 0 vertex 2 3 0 }\n"
               "polygon { points 3 vertex 4 3 0 vertex 3 2 0 vertex 2 3 0 }\n");
  const Examined examined = examine(folder.path(), {"part.b", "--fix", "out.b"});
  CHECK(examined.codes() == Codes{"off_centre", "leaves_picture", "duplicate_faces", "open_edges"});
  CHECK(examined.left() == Codes{"open_edges"});
  CHECK(examine(folder.path(), {"out.b"}).codes() == Codes{"open_edges"});
}

TEST_CASE(
    "a colour that is named and not there is an error with its place, a note where one is given") {
  const TemporaryFolder folder;
  const std::string faces =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl red\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  folder.write("part.obj", "mtllib none.mtl\n" + faces);
  folder.write("part.b",
               "surface { diffuse red } sphere { center 0 0 0 radius .3 }\n"
               "studio { angle 50 resolution 256 256 ambient 1 1 1 }\n");
  for (const auto& [file, place, what] :
       {std::tuple{"part.obj", "part.obj:1: ", "mtllib 'none.mtl' is not there"},
        {"part.b", "part.b:1: ", "the colour 'red' is not defined"}}) {
    CAPTURE(file);
    const Examined examined = examine(folder.path(), {file});
    CHECK(examined.exit_code == 1);
    CHECK(examined.codes().contains("missing_colour"));
    CHECK(examined.json["objects"][0]["errors"] == 1);
    for (const Json& finding : examined.json["objects"][0]["findings"]) {
      if (finding["code"] != "missing_colour") continue;
      CHECK_THAT(finding["message"].get<std::string>(),
                 Catch::Contains(place) && Catch::Contains(what));
      CHECK_THAT(finding["cure"].get<std::string>(), Catch::Contains("--missing-colour"));
    }
    CHECK(examine(folder.path(), {file, "--fix", "grey.b"}).left().contains("missing_colour"));
    folder.write("given.toml", "scene = \"" + std::string(file) +
                                   "\"\n[mesh]\nmissing_colour = [0.8, 0.1, 0.1]\n");
    const Examined given = examine(folder.path(), {"given.toml"});
    CHECK(given.exit_code == 0);
    CHECK(given.codes().empty());
    const Examined fixed = examine(folder.path(), {"given.toml", "--fix", "out.b"});
    CHECK(fixed.left().empty());
    CHECK_FALSE(examine(folder.path(), {"out.b"}).codes().contains("missing_colour"));
  }
}

TEST_CASE("a project's distance and segmentation decide what is too small and too alike") {
  const TemporaryFolder folder;
  folder.write("box.ply", ply_text(cuboid({-40, -30, -20}, {40, 30, 20})));
  folder.write("far.toml", "scene = \"box.ply\"\n[camera]\ndistance = [2, 40]\n");
  folder.write("blind.toml", "scene = \"box.ply\"\n[segmentation]\nchroma_step = 200\n");
  CHECK(examine(folder.path(), {"box.ply"}).exit_code == 0);
  const Examined far = examine(folder.path(), {"far.toml"});
  CHECK(far.codes() == Codes{"part_too_small"});
  CHECK(examine(folder.path(), {"blind.toml"}).codes().contains("inseparable_colours"));
}

TEST_CASE("files that cannot be read, and outputs that make no sense, are refused in one line") {
  const TemporaryFolder folder;
  folder.write("empty.obj", "");
  folder.write("cut.ply", ply_text(sick_cuboid()).substr(0, 400));
  folder.write("nan.off", "OFF\n3 1 0\n0 0 0\nnan 0 0\n0 1 0\n3 0 1 2\n");
  folder.write("point.off", "OFF\n3 1 0\n1 1 1\n1 1 1\n1 1 1\n3 0 1 2\n");
  folder.write("far.off", "OFF\n3 1 0\n0 0 0\n1e300 0 0\n0 1e300 0\n3 0 1 2\n");
  folder.write("box.ply", ply_text(sick_cuboid()));
  folder.write("part.b", "surface { diffuse 1 0 0 } sphere { center 0 0 0 radius .3 }\n");
  const auto run = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "doctor");
    return run_aspectc(folder.path(), arguments);
  };
  for (const char* file : {"none.b", "empty.obj", "cut.ply", "nan.off", "point.off", "far.off"})
    check_refused(run({file}), 1, file);
  check_refused(run({"box.ply", "--fix", "out.obj"}), 2, "--fix writes .b or .ply");
  check_refused(run({"box.ply", "--fix", "box.ply"}), 2, "both read and written");
  check_refused(run({"part.b", "--fix", "out.ply"}), 2, "written as .b alone");
  check_refused(run({"box.ply", "--fix", "none/out.b"}), 1, "none/out.b");
  folder.write("checks.b",
               "studio { angle 50 resolution 64 64 ambient 1 1 1 }\nsurface { diffuse 1 0 0 "
               "texture { checker } }\n"
               "sphere { center 0 0 0 radius .3 }\n");
  check_refused(run({"checks.b", "--fix", "out.b"}), 1, "textures");
  CHECK_FALSE(fs::exists(folder.path() / "out.b"));
}

TEST_CASE("a shaded mesh gets one warning of its colours, with the share and the cure") {
  const TemporaryFolder folder;
  folder.write("ball.ply", ply_text(shaded_ball()));
  const Examined sick = examine(folder.path(), {"ball.ply"});
  CHECK(sick.exit_code == 1);
  std::vector<Json> told;
  for (const Json& finding : sick.json["objects"][0]["findings"])
    if (finding["group"] == "colours" || finding["group"] == "visibility") told.push_back(finding);
  REQUIRE(told.size() == 1);
  CHECK(told[0]["code"] == "crowded_colours");
  CHECK_THAT(told[0]["message"].get<std::string>(), Catch::Contains("% of the surface"));
  CHECK_THAT(told[0]["cure"].get<std::string>(), Catch::Contains("--merge-colours 5"));
  // It sums up every pair, the one with the longest border first.
  const Json& pairs = told[0]["examples"];
  CHECK(pairs.size() == told[0]["count"].get<std::size_t>());
  for (std::size_t k = 1; k < pairs.size(); ++k)
    REQUIRE(pairs[k]["count"].get<std::size_t>() <= pairs[k - 1]["count"].get<std::size_t>());
  const auto lines = [](const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
  };
  CHECK(lines(run_aspectc(folder.path(), {"doctor", "ball.ply"}).out) < 8);
  CHECK(lines(run_aspectc(folder.path(), {"doctor", "ball.ply", "--all"}).out) >
        static_cast<long>(pairs.size()));
}

TEST_CASE("A picture shows what is wrong, and is named in the text and in JSON") {
  const TemporaryFolder folder;
  folder.write("sick.ply", ply_text(sick_cuboid()));
  const Outcome told = run_aspectc(folder.path(), {"doctor", "sick.ply", "--picture", "sick.png"});
  CHECK(told.exit_code == 1);
  CHECK_THAT(told.out, Catch::Contains("    1 warning zero_area_faces: ") &&
                           Catch::Contains("sick.png: written, with the findings"));
  const cv::Mat picture = cv::imread((folder.path() / "sick.png").string());
  CHECK(picture.cols > 1000);
  const Examined examined = examine(folder.path(), {"sick.ply", "--picture", "sick.png"});
  CHECK(examined.json["pictures"] == Json{"sick.png"});
  CHECK(examined.json["objects"][0]["findings"][0]["number"] == 1);
  check_refused(run_aspectc(folder.path(), {"doctor", "sick.ply", "--picture", "none/x.png"}), 1,
                "none/x.png: cannot be written");
  folder.write("two.toml",
               "[[object]]\nname = \"a\"\nscene = \"sick.ply\"\n[[object]]\nname = \"b\"\n"
               "scene = \"sick.ply\"\n");
  check_refused(run_aspectc(folder.path(), {"doctor", "two.toml", "--picture", "x.png"}), 2,
                "--picture names one file");
}

TEST_CASE("merged colours are judged and shown: each half of the picture has its own") {
  const TemporaryFolder folder;
  folder.write("ball.ply", ply_text(shaded_ball()));
  const Examined merged = examine(folder.path(), {"ball.ply", "--merge-colours", "5"});
  CHECK(merged.codes().count("crowded_colours") == 0);
  const auto& findings = merged.json["objects"][0]["findings"];
  const auto note = std::find_if(findings.begin(), findings.end(), [](const Json& finding) {
    return finding["code"] == "merged_colours";
  });
  REQUIRE(note != findings.end());
  CHECK_THAT((*note)["message"].get<std::string>(), Catch::Contains("colours are 5 now"));
  CHECK_THAT((*note)["cure"].get<std::string>(),
             Catch::Contains("aspectc ball.ply --merge-colours 5"));
  CHECK(merged.json["pictures"] == Json{"ball.colours.png"});
  const cv::Mat picture = cv::imread((folder.path() / "ball.colours.png").string());
  REQUIRE(picture.cols > 1000);
  const auto colours_in = [&](int left) {
    std::set<std::array<std::uint8_t, 3>> colours;
    for (int y = 16; y < 500; ++y)
      for (int x = left; x < left + 500; ++x) {
        const auto& pixel = picture.at<cv::Vec3b>(y, x);
        colours.insert({pixel[0], pixel[1], pixel[2]});
      }
    return colours.size();
  };
  CHECK(colours_in(8) > 100);
  CHECK(colours_in(picture.cols / 2 + 8) == 5);  // four paints are in sight, and the background
}

TEST_CASE("merged colours go into an index and a store, and explain knows them") {
  const TemporaryFolder folder;
  folder.write("ball.ply", ply_text(shaded_ball()));
  std::vector<std::string> words = {"ball.ply", "--merge-colours", "5", "--level",
                                    "1",        "--small-cluster", "0"};
  const Outcome compiled = run_aspectc(folder.path(), words);
  INFO(compiled.err);
  REQUIRE(compiled.exit_code == 0);
  const Outcome same = run_aspectc(folder.path(), words);
  CHECK_THAT(same.out, Catch::Contains("is up to date"));
  const Outcome explained =
      run_aspectc(folder.path(), {"explain", "ball.store", "--views", "10", "--cure-level", "1"});
  INFO(explained.err);
  CHECK(explained.exit_code == 0);
  CHECK_THAT(explained.out, Catch::Contains("accuracy to expect"));
  words[2] = "4";
  words.emplace_back("--no-store");
  CHECK_THAT(run_aspectc(folder.path(), words).out, Catch::Contains("classes cover"));
}

TEST_CASE("colours are merged of meshes alone, into two at least") {
  const TemporaryFolder folder;
  folder.write("part.b", "sphere { center 0 0 0 radius .2 }");
  check_refused(run_aspectc(folder.path(), {"part.b", "--merge-colours", "3"}), 1,
                "part.b: is a Bob scene, and colours are merged of meshes alone");
  check_refused(run_aspectc(folder.path(), {"doctor", "part.b", "--merge-colours", "3"}), 1,
                "part.b: is a Bob scene");
  CHECK(run_aspectc(folder.path(), {"part.b", "--merge-colours", "1"}).exit_code == 2);
}

}  // namespace aspect
