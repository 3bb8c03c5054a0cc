// aspectc's public contract: exit codes, messages, files.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "runtime/recognition/class_index.h"
#include "tests/temporary_folder.h"
#include "tests/tools/aspectc/run_aspectc.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Catch::StartsWith;
using nlohmann::json;

constexpr const char* kScene = R"(
studio { at 0 0 0 up 0 0 1 angle 50 resolution 128 128 antialias none threshold 1 aspect 1
         ambient 1 1 1 }
surface { diffuse .8 .1 .1 }
polygon { points 4 vertex -.2 -.2 .2 vertex .2 -.2 .2 vertex .2 .2 .2 vertex -.2 .2 .2 }
surface { diffuse .1 .8 .1 }
polygon { points 4 vertex .2 -.2 -.2 vertex .2 .2 -.2 vertex .2 .2 .2 vertex .2 -.2 .2 }
surface { diffuse .1 .1 .8 }
polygon { points 4 vertex -.2 .2 -.2 vertex .2 .2 -.2 vertex .2 .2 .2 vertex -.2 .2 .2 }
surface { diffuse .8 .8 .1 }
polygon { points 4 vertex -.2 -.2 -.2 vertex .2 -.2 -.2 vertex .2 .2 -.2 vertex -.2 .2 -.2 }
)";

class Workplace {
 public:
  Workplace() { folder_.write("part.b", kScene); }
  Outcome run(const std::vector<std::string>& arguments) const {
    return run_aspectc(folder_.path(), arguments);
  }
  fs::path file(const std::string& name) const { return folder_.path() / name; }
  const TemporaryFolder& folder() const { return folder_; }

  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path()))
      names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  TemporaryFolder folder_;
};

// A failure: exit code 1, nothing on stdout, one line on stderr that has all of these words.
void check_fails(const Outcome& outcome, const std::vector<std::string>& words) {
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.err, StartsWith("aspectc: "));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK(outcome.err.back() == '\n');
  for (const std::string& word : words) CHECK_THAT(outcome.err, Contains(word));
}

void check_usage(const Outcome& outcome, const std::string& word) {
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.err, Contains(word));
}

}  // namespace

TEST_CASE("a scene becomes an index of its name, here, beside its store") {
  const Workplace here;
  const Outcome outcome = here.run({"part.b", "--level", "3"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  CHECK_THAT(outcome.out, StartsWith("part.aspect: ") && Contains("classes cover"));
  CHECK(here.files() == std::vector<std::string>{"err", "out", "part.aspect", "part.aspect.inputs",
                                                 "part.b", "part.store"});
  const ClassIndex index = load_index(here.file("part.aspect")).value();
  CHECK(index.object == "part");
  CHECK(index.level == 3);
  CHECK(index.classes.size() > 5);
}

TEST_CASE("the same bytes come out with a store and without, with one thread and with two") {
  const Workplace here;
  for (const std::vector<std::string>& how : std::vector<std::vector<std::string>>{
           {"--no-store", "--jobs", "1"}, {"--jobs", "2"}, {"--store", "other.store"}}) {
    std::vector<std::string> words = {"part.b", "--level", "3", "-o",
                                      std::to_string(here.files().size()) + ".aspect"};
    words.insert(words.end(), how.begin(), how.end());
    CHECK(here.run(words).exit_code == 0);
  }
  std::vector<std::string> bytes;
  for (const std::string& name : here.files())
    if (name.ends_with(".aspect")) bytes.push_back(read_file(here.file(name)));
  REQUIRE(bytes.size() == 3);
  CHECK((bytes[0].size() > 1000 && bytes[0] == bytes[1] && bytes[1] == bytes[2]));
}

TEST_CASE("the statistics have every key that scripts rely on, and they add up") {
  const Workplace here;
  REQUIRE(here.run({"part.b", "--level", "3", "--threshold", "20000", "--cluster-threshold",
                    "90000", "--types", "17", "--jobs", "2", "--stats", "s.json"})
              .exit_code == 0);
  const json stats = json::parse(read_file(here.file("s.json")));
  for (const char* key :
       {"object", "level", "threshold", "cluster_threshold", "triangles", "views", "match_calls",
        "matches_executed", "clusters", "area_fraction", "contour_types", "index_bytes", "threads"})
    CHECK(stats.contains(key));
  for (const char* key : {"total", "render", "features", "match", "cluster", "types", "emit"})
    CHECK(stats["seconds"].at(key).get<double>() >= 0);
  CHECK(stats["object"] == "part");
  CHECK(stats["level"] == 3);
  CHECK(stats["threshold"] == 20000.0);
  CHECK(stats["cluster_threshold"] == 90000.0);
  CHECK(stats["triangles"] == 1280);
  CHECK(stats["views"] == 642);
  CHECK(stats["contour_types"] == 17);
  CHECK(stats["threads"] == 2);
  CHECK(stats["index_bytes"] == fs::file_size(here.file("part.aspect")));
  CHECK(stats["match_calls"] >= stats["matches_executed"]);
  CHECK(stats["seconds"]["total"].get<double>() > 0);
  const double area = stats["area_fraction"];
  CHECK((area > 0.1 && area <= 1.0));
}

TEST_CASE("a scene that is not there or that is none is refused in one line with file and line") {
  const Workplace here;
  check_fails(here.run({"missing.b"}), {"missing.b"});
  here.folder().write("bad.b", "surface { diffuse 1 0 0 }\npolygon { points 4 vertex x\n");
  check_fails(here.run({"bad.b"}), {"bad.b:2"});
  here.folder().write("empty.b", "");
  check_fails(here.run({"empty.b"}), {"empty", "nothing to render"});
  check_fails(here.run({"."}), {"."});
  CHECK_FALSE(fs::exists(here.file("missing.aspect")));
  CHECK_FALSE(fs::exists(here.file("bad.aspect")));
}

TEST_CASE("an output that cannot be written is refused, and nothing is left behind") {
  const Workplace here;
  const Outcome outcome = here.run(
      {"part.b", "--level", "2", "--min-level", "2", "-o", "none/x.aspect", "--store", "p.store"});
  check_fails(outcome, {"none/x.aspect", "cannot be written"});
  check_fails(here.run({"part.b", "--level", "3", "--no-store", "--stats", "none/s.json"}),
              {"none/s.json", "cannot be written"});
  fs::create_directory(here.file("folder.aspect"));
  check_fails(here.run({"part.b", "--level", "3", "--no-store", "-o", "folder.aspect"}),
              {"folder.aspect", "cannot be written"});
  for (const std::string& name : here.files()) CHECK_THAT(name, !Contains(".part"));
}

TEST_CASE("an output that cannot be written is noticed before the work, not after it") {
  const Workplace here;
  check_fails(here.run({"part.b", "--level", "3", "-o", "none/x.aspect", "--store", "p.store"}),
              {"none/x.aspect"});
  CHECK_FALSE(fs::exists(here.file("p.store")));
}

TEST_CASE("an output that is the store, or the scene, is refused") {
  const Workplace here;
  check_usage(here.run({"part.b", "--level", "3", "-o", "part.store"}), "part.store");
  check_usage(here.run({"part.b", "--level", "3", "-o", "x.aspect", "--store", "x.aspect"}),
              "x.aspect");
  check_usage(here.run({"part.b", "--level", "3", "-o", "./part.b"}), "part.b");
  CHECK(read_file(here.file("part.b")) == kScene);
}

TEST_CASE("a store of other options is refused in one line, and without it the run goes on") {
  const Workplace here;
  REQUIRE(here.run({"part.b", "--level", "3"}).exit_code == 0);
  const std::string before = read_file(here.file("part.aspect"));
  check_fails(here.run({"part.b", "--level", "3", "--cluster-threshold", "90000"}),
              {"part.store", "other options"});
  here.folder().write("part.b", std::string(kScene) + "/* a comment changes nothing */");
  CHECK(here.run({"part.b", "--level", "3"}).exit_code == 0);
  here.folder().write("part.b", std::string(kScene) + "surface { diffuse 0 0 1 }");
  check_fails(here.run({"part.b", "--level", "3"}), {"part.store", "another scene"});
  CHECK(read_file(here.file("part.aspect")) == before);
}

TEST_CASE("an index that cannot hold a single class is refused, not written empty") {
  const Workplace here;
  check_fails(here.run({"part.b", "--level", "3", "--max-index-kib", "1"}), {"--max-index-kib"});
  CHECK_FALSE(fs::exists(here.file("part.aspect")));
  CHECK(here.run({"part.b", "--level", "3", "--max-index-kib", "4"}).exit_code == 0);
  CHECK(fs::file_size(here.file("part.aspect")) <= 4096);
}

TEST_CASE("wrong usage exits with 2 and says what was wrong") {
  const Workplace here;
  check_usage(here.run({}), "no scene given");
  check_usage(here.run({"part.b", "--threshold", "5000", "--cluster-threshold", "4000"}),
              "--cluster-threshold 4000 is below --threshold 5000");
  check_usage(here.run({"part.b", "--level", "11"}), "--level");
  check_usage(here.run({"part.b", "--level", "x"}), "--level");
  check_usage(here.run({"part.b", "--types", "257"}), "--types");
  check_usage(here.run({"part.b", "--types", "0"}), "--types");
  check_usage(here.run({"part.b", "--scoring", "best"}), "--scoring");
  check_usage(here.run({"part.b", "--jobs", "0"}), "--jobs");
  check_usage(here.run({"part.b", "--threshold", "-1"}), "--threshold");
  check_usage(here.run({"part.b", "--nonsense"}), "--nonsense");
  check_usage(here.run({"part.b", "other.b"}), "other.b");
  check_usage(here.run({"render", "part.b", "-o", "x.png"}), "--from");
  check_usage(here.run({"render", "part.b", "--from", "0,0,0", "-o", "x.png"}), "--from");
  check_usage(here.run({"render", "part.b", "--from", "1,2", "-o", "x.png"}), "--from");
  CHECK(here.files() == std::vector<std::string>{"err", "out", "part.b"});
}

TEST_CASE("help and version go to stdout and exit with 0") {
  const Workplace here;
  for (const char* option : {"--help", "--version"}) {
    const Outcome outcome = here.run({option});
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out.size() > 3);
    CHECK(outcome.err.empty());
  }
  CHECK_THAT(here.run({"--help"}).out, Contains("--max-index-kib") && Contains("inspect"));
}

TEST_CASE("progress is printed where it is asked for and only there") {
  const Workplace here;
  const Outcome shown = here.run({"part.b", "--level", "3", "--no-store", "--progress", "always"});
  CHECK_THAT(shown.err, Contains("part level 3/3") && Contains("of 642 views"));
  CHECK(here.run({"part.b", "--level", "3", "--no-store"}).err.empty());
}

TEST_CASE("explain tells of a store, without its scene, and refuses what is none") {
  const Workplace here;
  REQUIRE(here.run({"part.b", "--level", "2"}).exit_code == 0);
  fs::remove(here.file("part.b"));
  const Outcome words = here.run({"explain", "part.store", "--views", "30"});
  CHECK(words.exit_code == 0);
  CHECK(words.err.empty());
  CHECK_THAT(words.out, Contains("accuracy to expect") && Contains("symmetry: none"));
  const json printed =
      json::parse(here.run({"explain", "part.store", "--views", "30", "--json"}).out);
  CHECK(printed.at("object") == "part");
  CHECK(printed.at("views") == 30);
  const std::string help = here.run({"explain", "--help"}).out;
  for (const auto& [key, value] : printed.items())
    if (key != "object" && key != "store" && key != "views" && key != "aspects")
      CHECK_THAT(help, Contains(key));
  check_fails(here.run({"explain", "none.store"}), {"none.store"});
  check_fails(here.run({"explain", "part.aspect"}), {"part.aspect"});
  check_usage(here.run({"explain", "part.store", "--views", "0"}), "--views");
}

TEST_CASE("models-info writes sizes and symmetries as BOP does, and refuses what is no index") {
  const Workplace here;
  REQUIRE(here.run({"part.b", "--level", "2"}).exit_code == 0);
  CHECK(here.run({"models-info", "part.aspect", "part.aspect", "-o", "m.json"}).exit_code == 0);
  const json printed = json::parse(here.run({"models-info", "part.aspect", "part.aspect"}).out);
  std::ifstream file(here.file("m.json"));
  CHECK(json::parse(file) == printed);
  REQUIRE(printed.size() == 2);
  const json& model = printed.at("2");
  CHECK(model.at("name") == "part");
  CHECK(model.at("diameter").get<double>() == Approx(0.4 * std::sqrt(3.0)));
  CHECK(model.at("min_z").get<double>() == Approx(-0.2));
  CHECK(model.at("size_x").get<double>() == Approx(0.4));
  CHECK_FALSE(model.contains("symmetries_discrete"));
  check_fails(here.run({"models-info", "part.b"}), {"part.b", "not a class index"});
}

TEST_CASE("models-info gives symmetries as matrices by rows") {
  const Workplace here;
  here.folder().write("bar.b", R"(
studio { at 0 0 0 up 0 0 1 angle 50 resolution 128 128 antialias none aspect 1 ambient 1 1 1 }
surface { diffuse .8 .1 .1 } cylinder { base 0 0 -.2 apex 0 0 .2 radius .1 }
surface { diffuse .1 .8 .1 } ring { center 0 0 .2 normal 0 0 1 radius .1 }
                             ring { center 0 0 -.2 normal 0 0 1 radius .1 })");
  REQUIRE(here.run({"bar.b", "--level", "2"}).exit_code == 0);
  const json bar = json::parse(here.run({"models-info", "bar.aspect"}).out).at("1");
  CHECK(bar.at("symmetries_continuous") ==
        json::parse(R"([{"axis": [0, 0, 1], "offset": [0, 0, 0]}])"));
  REQUIRE(bar.at("symmetries_discrete").size() == 1);
  const auto m = bar.at("symmetries_discrete").at(0).get<std::vector<double>>();
  REQUIRE(m.size() == 16);
  CHECK(m[10] == -1);
  CHECK(m[0] == -m[5]);
  CHECK(std::vector(m.begin() + 12, m.end()) == std::vector<double>{0, 0, 0, 1});
}

TEST_CASE("inspect prints an index in words and as JSON, and refuses what is none") {
  const Workplace here;
  REQUIRE(here.run({"part.b", "--level", "3"}).exit_code == 0);
  const ClassIndex index = load_index(here.file("part.aspect")).value();
  const json printed = json::parse(here.run({"inspect", "part.aspect", "--json"}).out);
  CHECK(printed["object"] == "part");
  CHECK(printed["classes"].size() == index.classes.size());
  CHECK(printed["bytes"] == index.file_bytes);
  CHECK(printed["classes"][0]["contours"].size() == index.classes[0].contours.count);
  CHECK(printed["classes"][0]["contours"][0]["name"] == "A");
  // Patches that are divided along borders are covered as well.
  double whole = 0;
  for (const json& aspect : printed["classes"]) whole += aspect["area_fraction"].get<double>();
  CHECK(printed["covered_fraction"] > whole);
  CHECK(printed["covered_fraction"] <= 1.0);
  CHECK_THAT(here.run({"inspect", "part.aspect"}).out, Contains("object part"));
  check_fails(here.run({"inspect", "part.b"}), {"part.b", "not a class index"});
  check_fails(here.run({"inspect", "none.aspect"}), {"none.aspect"});
}

TEST_CASE("inspect shows the golden frame and writes its picture") {
  const Workplace here;
  REQUIRE(here.run({"part.b", "--level", "3", "--no-store", "--stats", "s.json"}).exit_code == 0);
  const ClassIndex index = load_index(here.file("part.aspect")).value();
  REQUIRE(index.golden);
  const json golden =
      json::parse(here.run({"inspect", "part.aspect", "--json"}).out)["golden_frame"];
  CHECK(golden["width"] == index.golden->width_px);
  CHECK(golden["class"] == index.golden->class_id);
  CHECK(golden["matched"] == golden["regions"]);
  CHECK(json::parse(read_file(here.file("s.json")))["golden_frame_bytes"] > golden["bytes"]);
  CHECK_THAT(here.run({"inspect", "part.aspect"}).out, Contains("golden frame: "));
  REQUIRE(here.run({"inspect", "part.aspect", "--golden", "g.png"}).exit_code == 0);
  CHECK(read_file(here.file("g.png")).substr(1, 3) == "PNG");
  check_fails(here.run({"inspect", "part.aspect", "--golden", "none/g.png"}), {"none/g.png"});
  // In so small an index there is no room for it, and it is said.
  const Outcome small = here.run({"part.b", "--level", "3", "--no-store", "--max-index-kib", "1"});
  if (small.exit_code == 0)
    CHECK_THAT(small.err, Contains("warning: part.aspect: no golden frame"));
}

TEST_CASE("render writes a picture of a view, as it is and as it is seen") {
  const Workplace here;
  CHECK(here.run({"render", "part.b", "--from", "1,0.5,2", "-o", "a.png"}).exit_code == 0);
  CHECK(
      here.run({"render", "part.b", "--from", "1,0.5,2", "--segmented", "-o", "b.png"}).exit_code ==
      0);
  const std::string plain = read_file(here.file("a.png")), seen = read_file(here.file("b.png"));
  CHECK((plain.substr(1, 3) == "PNG" && seen.substr(1, 3) == "PNG" && plain != seen));
  check_fails(here.run({"render", "none.b", "--from", "1,0,0", "-o", "c.png"}), {"none.b"});
  check_fails(here.run({"render", "part.b", "--from", "1,0,0", "-o", "none/c.png"}),
              {"none/c.png"});
}

}  // namespace aspect
