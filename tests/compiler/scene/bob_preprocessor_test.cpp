#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "compiler/scene/bob_reader.h"
#include "tests/compiler/scene/scene_samples.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

constexpr const char* kBall = "sphere { center 0 0 0 radius .1 }\n";

std::size_t count_of(std::string_view text) {
  return scene_of(text).primitives.size();
}

}  // namespace

TEST_CASE("comments are white space and do not nest") {
  CHECK(scene_of("sphere/*a*/{center 0/**/0 0// to the end }\n radius .1}").source ==
        "sphere { center 0 0 0 radius .1 }");
  CHECK(count_of(std::string("/* one /* still one */") + kBall) == 1);
  CHECK(count_of(std::string("/* *//**/ /***/") + kBall) == 1);
}

TEST_CASE("the source does not change with comments, white space and macros") {
  const std::string plain = scene_of("sphere { center 1 -2 3 radius 2 - 1 }").source;
  CHECK(plain == "sphere { center 1 -2 3 radius 2 - 1 }");
  CHECK(scene_of("#define R 2 - 1\nsphere{ /* c */ center 1\t-2\r\n3 radius R}").source == plain);
}

TEST_CASE("the source keeps what white space means to signs") {
  CHECK(scene_of("sphere { center 1 - 2 3 4 radius 1 }").source !=
        scene_of("sphere { center 1 -2 3 radius 1 }").source);
  CHECK(scene_of("sphere { center 1 2 3*2 radius 1 }").source !=
        scene_of("sphere { center 1 2 3 * 2 radius 1 }").source);
}

TEST_CASE("a macro may hold whole statements over continued lines") {
  const std::string text =
      "#define BALLS sphere { center 0 0 0 \\\n  radius R } \\ \n BALL // and one more \\\n BALL\n"
      "#define BALL sphere { center 0 0 0 radius R }\n#define R .1\nBALLS BALLS";
  CHECK(count_of(text) == 6);
}

TEST_CASE("a comment may stand in a macro and continue it") {
  CHECK(count_of("#define BALL sphere { /* a\n b */ center 0 0 0 radius .1 }\nBALL") == 1);
}

TEST_CASE("names in a body are expanded when it is used and a redefinition replaces") {
  const Scene scene = scene_of(
      "#define X R\n#define R .1\nsphere { center 0 0 0 radius X }\n"
      "#define R .2\nsphere { center 0 0 0 radius X }");
  CHECK(shape_of<Sphere>(scene, 0).radius == .1);
  CHECK(shape_of<Sphere>(scene, 1).radius == .2);
}

TEST_CASE("an undefined macro is a plain word again") {
  CHECK(error_of("#define BALL\n#undef BALL\n#undef NEVER\nBALL").substr(0, 24) ==
        "s.b:4: unknown word 'BAL");
}

TEST_CASE("an empty macro leaves nothing") {
  CHECK(count_of(std::string("#define NOTHING\nNOTHING ") + kBall) == 1);
}

TEST_CASE("conditions choose and nest") {
  const std::string ball = kBall;
  CHECK(count_of("#ifdef A\nnonsense\n#else\n" + ball + "#endif") == 1);
  CHECK(count_of("#define A\n#ifdef A\n" + ball + "#else\nnonsense\n#endif") == 1);
  CHECK(count_of("#define A\n#ifndef A\nnonsense\n#endif\n" + ball) == 1);
  CHECK(count_of("#ifndef A\n" + ball + "#endif\n" + ball) == 2);
  CHECK(count_of("#ifdef A\n#ifndef B\nx\n#else\ny\n#endif\n#define C\n#include no\n#wrong\n#\n"
                 "#else\n#ifndef C\n" +
                 ball + "#endif\n#endif") == 1);
}

TEST_CASE("a directive may stand behind a comment and white space") {
  CHECK(count_of(std::string(" /* a */ # define A\n#ifdef A\n") + kBall + "#endif") == 1);
}

TEST_CASE("line ends of Windows are accepted") {
  CHECK(count_of("#define BALL sphere { \\\r\n center 0 0 0 radius .1 }\r\nBALL\r\n") == 1);
}

TEST_CASE("includes are found beside the including file, then on the include path") {
  const TemporaryFolder folder;
  folder.write("lib/ball.bo", "sphere { center 0 0 0 radius R }\n");
  folder.write("scene/colours/r.bc", "#define R .1\n#include \"../near ball.bo\"\n");
  folder.write("scene/near ball.bo", "#include ball.bo\n");
  const auto main =
      folder.write("scene/main.b", "#include colours/r.bc // radius\n#include ball.bo");
  const Result<Scene> scene = read_bob(main, {folder.path() / "none", folder.path() / "lib"});
  REQUIRE(scene.ok());
  CHECK(scene.value().primitives.size() == 2);
  CHECK(scene.value().name == "main");
}

TEST_CASE("a file beside the including one wins over the include path") {
  const TemporaryFolder folder;
  folder.write("lib/r.bc", "#define R .2");
  folder.write("r.bc", "#define R .1");
  const auto main = folder.write("main.b", "#include r.bc\nsphere { center 0 0 0 radius R }");
  const Result<Scene> scene = read_bob(main, {folder.path() / "lib"});
  REQUIRE(scene.ok());
  CHECK(shape_of<Sphere>(scene.value()).radius == .1);
}

TEST_CASE("an error in an include shows the chain of includes") {
  const TemporaryFolder folder;
  const std::string c = folder.write("c.bc", "\n\nspher").string();
  const std::string b = folder.write("b.bo", "\n#include c.bc").string();
  const std::string a = folder.write("a.b", "#include b.bo").string();
  const std::string error = error_of_file(a);
  CHECK(error == c + ":3: unknown word 'spher'; the nearest known one is 'sphere' (included from " +
                     b + ":2, " + a + ":1)");
}

TEST_CASE("a missing include shows the chain of includes") {
  const TemporaryFolder folder;
  const std::string b = folder.write("b.bo", "\n#include c.bc").string();
  const std::string a = folder.write("a.b", "#include b.bo").string();
  const std::string error = error_of_file(a);
  CHECK(error == b + ":2: " + (folder.path() / "c.bc").string() +
                     ": no such file; check the path (included from " + a + ":1)");
}

TEST_CASE("a cycle of includes is an error that shows the chain") {
  const TemporaryFolder folder;
  const std::string b = folder.write("b.bo", "#include x/../a.b").string();
  folder.write("x/unused", "");
  const std::string a = folder.write("a.b", "\n#include b.bo").string();
  const std::string error = error_of_file(a);
  CHECK(error == b + ":1: " + (folder.path() / "x/../a.b").string() +
                     " includes itself; break the cycle (included from " + a + ":2)");
}

TEST_CASE("a condition must close in the file that opens it") {
  const TemporaryFolder folder;
  const std::string b = folder.write("b.bo", "#ifdef A").string();
  const std::string a = folder.write("a.b", "#include b.bo\n#endif").string();
  const std::string error = error_of_file(a);
  CHECK(error == b +
                     ":1: this condition is never closed; write #endif in the same file "
                     "(included from " +
                     a + ":1)");
}

TEST_CASE("only regular files are read") {
  const TemporaryFolder folder;
  CHECK(error_of_file(folder.path()) ==
        folder.path().string() + ": not a regular file; give a plain one");
  CHECK(error_of_file(folder.path() / "none.b") ==
        (folder.path() / "none.b").string() + ": no such file; check the path");
  CHECK(error_of("#include /dev/zero") == "s.b:1: /dev/zero: not a regular file; give a plain one");
}

TEST_CASE("an expansion bomb is an error, also where it leaves no words") {
  std::string bomb = "#define A0 SEED\n";
  for (int i = 1; i < 64; ++i) {
    bomb += fmt::format("#define A{0} A{1} A{1}\n", i, i - 1);
  }
  const std::string expected =
      "s.b:67: the macros expand past 1000000 words; define less at a time (in macro ";
  const std::string empty = "#define SEED\n#define END\n" + bomb + "A63";
  CHECK(error_of(empty).substr(0, expected.size()) == expected);
  const std::string full = "#define SEED surface { }\n#define END\n" + bomb + "A63";
  CHECK(error_of(full).substr(0, expected.size()) == expected);
}

TEST_CASE("includes that multiply are stopped") {
  const TemporaryFolder folder;
  for (int i = 0; i < 20; ++i) {
    folder.write(fmt::format("f{}", i), fmt::format("#include f{0}\n#include f{0}\n", i + 1));
  }
  folder.write("f20", "");
  const std::string error = error_of_file(folder.path() / "f0");
  CHECK(error.find("more than 10000 includes; join the files") != std::string::npos);
}

TEST_CASE("includes that never end are stopped by their depth") {
  const TemporaryFolder folder;
  for (int i = 0; i < 70; ++i) {
    folder.write(fmt::format("f{}", i), fmt::format("#include f{}\n", i + 1));
  }
  const std::string error = error_of_file(folder.path() / "f0");
  CHECK(error.find("files included more than 64 deep") != std::string::npos);
}

TEST_CASE("a message stays on one line whatever a file is called") {
  const TemporaryFolder folder;
  const std::string error = error_of_file(folder.write("two\nlines.b", "x"));
  CHECK(error.find("lines.b:1: ") != std::string::npos);
  CHECK(error.find('\n') == std::string::npos);
}

}  // namespace aspect
