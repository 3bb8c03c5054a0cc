// aspectc with projects and aspectc init, as their users start them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "runtime/recognition/index_bundle.h"
#include "tests/temporary_folder.h"
#include "tests/tools/aspectc/run_aspectc.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Catch::StartsWith;

constexpr const char* kScene = R"(
studio { at 0 0 0 up 0 0 1 angle 50 resolution 128 128 antialias none threshold 1 aspect 1
         ambient 1 1 1 }
surface { diffuse .8 .1 .1 }
polygon { points 4 vertex -.2 -.2 .2 vertex .2 -.2 .2 vertex .2 .2 .2 vertex -.2 .2 .2 }
surface { diffuse .1 .8 .1 }
polygon { points 4 vertex .2 -.2 -.2 vertex .2 .2 -.2 vertex .2 .2 .2 vertex .2 -.2 .2 }
surface { diffuse .1 .1 .8 }
polygon { points 4 vertex -.2 .2 -.2 vertex .2 .2 -.2 vertex .2 .2 .2 vertex -.2 .2 .2 }
)";

constexpr const char* kTwo = R"(
[subdivision]
level = 2
min_level = 2
[[object]]
scene = "part.b"
[[object]]
scene = "part.b"
name = "blue"
[[object.surface]]
index = 0
diffuse = [0.1, 0.6, 0.8]
)";

class Workplace {
 public:
  Workplace() { folder_.write("part.b", kScene); }
  Outcome run(const std::vector<std::string>& arguments) const {
    return run_aspectc(folder_.path(), arguments);
  }
  fs::path file(const std::string& name) const { return folder_.path() / name; }
  void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }

 private:
  TemporaryFolder folder_;
};

void check_fails(const Outcome& outcome, int exit_code, const std::string& beginning) {
  CHECK(outcome.exit_code == exit_code);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.err, StartsWith("aspectc: " + beginning));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
}

}  // namespace

TEST_CASE("a written project compiles to the bytes of the bare scene, from any folder") {
  const Workplace here;
  fs::create_directory(here.file("sub"));
  REQUIRE(here.run({"init", "part.b"}).exit_code == 0);
  REQUIRE(here.run({"init", "part.b", "-o", "sub/other.toml"}).exit_code == 0);
  const std::vector<std::string> how = {"--level", "2", "--min-level", "2", "--no-store", "-o"};
  std::vector<std::string> bytes;
  for (const char* input : {"part.b", "part.toml", "sub/other.toml"}) {
    std::vector<std::string> words = {input};
    words.insert(words.end(), how.begin(), how.end());
    words.push_back("x.aspect");
    REQUIRE(here.run(words).exit_code == 0);
    bytes.push_back(read_file(here.file("x.aspect")));
  }
  CHECK(bytes[0].size() > 1000);
  CHECK((bytes[0] == bytes[1] && bytes[0] == bytes[2]));
}

TEST_CASE("init never writes over a file, and refuses what it cannot read or write") {
  const Workplace here;
  here.write("part.toml", "mine");
  check_fails(here.run({"init", "part.b"}), 1, "part.toml: is there already");
  CHECK(read_file(here.file("part.toml")) == "mine");
  check_fails(here.run({"init", "none.b"}), 1, "none.b");
  check_fails(here.run({"init", "part.toml"}), 1, "part.toml: is a project itself");
  check_fails(here.run({"init", "part.b", "-o", "none/p.toml"}), 1, "none/p.toml: cannot be");
  CHECK(here.run({"init"}).exit_code == 2);
}

TEST_CASE("the command line wins over the project, and the project over the defaults") {
  const Workplace here;
  here.write("p.toml",
             "scene = \"part.b\"\n[subdivision]\nlevel = 1\nmin_level = 1\n[classes]\ntypes = 9\n");
  REQUIRE(here.run({"p.toml", "--level", "2", "--no-store"}).exit_code == 0);
  const ClassIndex index = load_index(here.file("part.aspect")).value();
  CHECK(index.level == 2);
  CHECK(index.types.size() == 9);
}

TEST_CASE("several objects of a project become an index each, here or in a folder") {
  const Workplace here;
  here.write("two.toml", kTwo);
  const Outcome outcome = here.run({"two.toml", "--stats", "s.json"});
  CHECK(outcome.err.empty());
  CHECK_THAT(outcome.out, StartsWith("part.aspect: ") && Contains("\nblue.aspect: "));
  CHECK(load_index(here.file("part.aspect")).value().object == "part");
  CHECK(load_index(here.file("blue.aspect")).value().object == "blue");
  CHECK((fs::exists(here.file("part.store")) && fs::exists(here.file("blue.store"))));
  const auto stats = nlohmann::json::parse(read_file(here.file("s.json")));
  REQUIRE(stats.size() == 2);
  CHECK(stats[1]["object"] == "blue");
  fs::create_directory(here.file("out.d"));
  CHECK(here.run({"two.toml", "-o", "out.d", "--no-store"}).exit_code == 0);
  CHECK(read_file(here.file("out.d/blue.aspect")) == read_file(here.file("blue.aspect")));
  check_fails(here.run({"two.toml", "-o", "x.aspect"}), 2, "x.aspect is no folder");
  check_fails(here.run({"two.toml", "--store", "x.store"}), 2, "--store names one store");
}

TEST_CASE("combined objects are one file that holds the bytes of each") {
  const Workplace here;
  here.write("two.toml", kTwo);
  REQUIRE(here.run({"two.toml", "--no-store"}).exit_code == 0);
  const Outcome outcome = here.run({"two.toml", "--combined", "true", "--no-store"});
  CHECK(outcome.exit_code == 0);
  const std::string bundle = read_file(here.file("two.aspect"));
  for (const char* name : {"part.aspect", "blue.aspect"}) {
    const std::size_t place = bundle.find(read_file(here.file(name)));
    REQUIRE(place != std::string::npos);
    CHECK(place % 16 == 0);
  }
  const auto indexes = load_index_file(here.file("two.aspect")).value();
  REQUIRE(indexes.size() == 2);
  CHECK((indexes[0].object == "part" && indexes[1].object == "blue"));
  const auto printed = nlohmann::json::parse(here.run({"inspect", "two.aspect", "--json"}).out);
  REQUIRE(printed.size() == 2);
  CHECK(printed[1]["object"] == "blue");
}

TEST_CASE("what is wrong with a project is told before anything is written") {
  const Workplace here;
  here.write("p.toml", "scene = \"part.b\"\n[subdivision]\nlevle = 3\n");
  check_fails(here.run({"p.toml"}), 1, "p.toml:3: [subdivision] levle is not known here; did you");
  here.write("p.toml", "scene = \"none.b\"\n");
  check_fails(here.run({"p.toml"}), 1, "none.b");
  here.write("p.toml", "[[object]]\nscene = \"part.b\"\n[[object]]\nscene = \"part.b\"\n");
  check_fails(here.run({"p.toml"}), 1, "p.toml: two objects are called part");
  here.write("p.toml", "scene = \"part.b\"\n");
  check_fails(here.run({"p.toml", "-o", "./p.toml"}), 2, "p.toml is given twice");
  check_fails(here.run({"p.toml", "--fx", "300"}), 2, "--fy is missing");
  CHECK_FALSE(fs::exists(here.file("part.aspect")));
}

TEST_CASE("a range of distances that cannot hold is a warning, and the index is made") {
  const Workplace here;
  here.write("p.toml",
             "scene = \"part.b\"\n[camera]\ndistance = [0.5, 30]\n[subdivision]\nlevel = "
             "1\nmin_level = 1\n");
  const Outcome outcome = here.run({"p.toml", "--no-store", "--small-cluster", "0"});
  CHECK_THAT(outcome.err, StartsWith("aspectc: warning: part: the object leaves the picture at "
                                     "distance 0.5") &&
                              Contains("warning: part: at distance 30 the smallest contour"));
}

TEST_CASE("a colour that is not found stops a compilation, unless a flag or a key gives one") {
  const Workplace here;
  const std::string scene(kScene);
  here.write("lost.b", "#define GREEN .1 .8 .1\n" + scene.substr(0, scene.find(".8 .1 .1")) +
                           "RED" + scene.substr(scene.find(".8 .1 .1") + 8));
  check_fails(here.run({"lost.b", "--level", "2", "--no-store"}), 1,
              "lost.b:5: the colour 'RED' is not defined; #define it; the nearest name is 'GREEN', "
              "or go on with --missing-colour R,G,B ([mesh] missing_colour in a project)");
  const std::string warning =
      "aspectc: warning: lost.b:5: the colour 'RED' is not defined; --missing-colour stands for it";
  const Outcome flag = here.run({"lost.b", "--level", "2", "--min-level", "2", "--no-store",
                                 "--missing-colour", "0.8,0.1,0.1", "-o", "flag.aspect"});
  CHECK(flag.exit_code == 0);
  CHECK_THAT(flag.err, Contains(warning));
  here.write("lost.toml",
             "scene = \"lost.b\"\n[subdivision]\nlevel = 2\nmin_level = 2\n"
             "[mesh]\nmissing_colour = [0.8, 0.1, 0.1]\n");
  const Outcome key = here.run({"lost.toml", "--no-store", "-o", "key.aspect"});
  CHECK(key.exit_code == 0);
  CHECK_THAT(key.err, Contains(warning));
  CHECK(fs::file_size(here.file("flag.aspect")) == fs::file_size(here.file("key.aspect")));
  CHECK(here.run({"lost.b", "--missing-colour", "2,0,0"}).exit_code == 2);
  // A project is written all the same, so that it can say the colour; a conversion can say it too.
  CHECK(here.run({"init", "lost.b", "-o", "new.toml"}).exit_code == 0);
  check_fails(here.run({"convert", "lost.b", "out.b"}), 1, "lost.b:5: the colour 'RED'");
  const Outcome converted =
      here.run({"convert", "lost.b", "out.b", "--missing-colour", "0.8,0.1,0.1"});
  CHECK(converted.exit_code == 0);
  CHECK_THAT(converted.err, Contains(warning));
  CHECK(here.run({"render", "out.b", "--from", "1,1,1", "-o", "out.png"}).exit_code == 0);
}

}  // namespace aspect
