// Whatever the bytes, the reader ends with a scene or one line: seeded mutations and cuts of a
// scene that uses the whole language.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <iterator>
#include <random>
#include <string>

#include "compiler/scene/bob_reader.h"
#include "tests/compiler/scene/scene_samples.h"

namespace aspect {
namespace {

constexpr std::string_view kEverything =
    "/* all */ #define COLOR1 0.237 0.105 0.878 // c\n"
    "#define BALL sphere { center 0 -.1 0 \\\n radius R }\n#define R (.1 + sqrt(4) / 100)\n"
    "#ifdef NO\nx\n#else\nstudio { at 0 0 0 up 0 1 0.05 angle 50 resolution 512 512 antialias "
    "adaptive samples 4 jitter depth 3 haze .1 aperture .01 focal_length 1 project flat 1\n"
    " threshold 1 aspect 1 ambient 1 1 1 }\n#endif\n#ifndef R\n#endif\n#undef NO\n"
    "light { type point position 1 -2 +3 color 1 1 1 no_shadows }\n"
    "light { type spherical center 1 1 1 radius .1 samples 4 falloff 2 at 0 0 0 min_angle 10 "
    "max_angle 20 }\nlight { type directional direction 0 0 -1 }\n"
    "surface { specular .5 .5 .5 transparent .2 .2 .2 ior 1.5 shine 10 1 1 1 fuzz .1 no_shadow "
    "no_antialias texture { checker 1 1 1 0 0 0 scale .1 translate 0 0 1 } }\n"
    "patch { vertex 0 0 0 normal 0 0 1 vertex .1 0 0 normal 0 0 1 vertex 0 .1 0 normal 0 1 1 }\n"
    "surface { diffuse COLOR1 * .5 ambient (1 0 0) cross (0 1 0) }\n"
    "transform { translate 0 -.1 0 rotate 0 0 90 scale .5 } transform { scale 2 -2 2 }\n"
    "BALL transform_pop\n"
    "polygon { points 4 vertex 0 0 0 vertex .1 0 0 vertex .1 .1 0 vertex 0 .1 0 }\n"
    "ring { center 0 0 0 normal 0 0 1 min_radius .1 max_radius .2 }\n"
    "cone { base 0 0 0 base_radius .2 apex 0 0 .1 apex_radius pow(.1 2) }\n"
    "cylinder { base 0 0 0 apex 0 0 .1 radius .2 } transform_pop\n";

// One line that names its place, or a scene within its limits.
void check_outcome(std::string_view text) {
  const Result<Scene> scene = parse_bob(text, "s.b");
  if (!scene.ok()) {
    const std::string error = error_of(text);
    const bool well_formed = error.substr(0, 4) == "s.b:" &&
                             error.find('\n') == std::string::npos &&
                             error.find("; ") != std::string::npos;
    if (!well_formed) FAIL("error: " << error);
    return;
  }
  for (const Primitive& primitive : scene.value().primitives) {
    const auto surface = static_cast<std::size_t>(primitive.surface);
    if (surface >= scene.value().surfaces.size()) FAIL("a primitive without a surface");
  }
  if (!std::isfinite(bounding_radius(scene.value()))) FAIL("a primitive without a size");
}

}  // namespace

TEST_CASE("the scene that the mutations start from is right") {
  const Scene scene = scene_of(kEverything);
  CHECK(scene.primitives.size() == 6);
  CHECK(scene.warnings.empty());
}

TEST_CASE("a scene cut off at any byte ends with a scene or one line") {
  for (std::size_t length = 0; length <= kEverything.size(); ++length) {
    check_outcome(kEverything.substr(0, length));
  }
  SUCCEED();
}

TEST_CASE("a scene with random bytes changed ends with a scene or one line") {
  std::mt19937 random(20240229);
  const std::string alphabet = "{}()+-*/.#\\\n \"0123456789eRxyz_";
  const auto below = [&](std::size_t count) { return random() % count; };
  for (int round = 0; round < 4000; ++round) {
    std::string text(kEverything);
    for (std::size_t changes = 1 + below(6); changes > 0; --changes) {
      const std::size_t at = below(text.size());
      const char byte =
          below(4) == 0 ? static_cast<char>(below(256)) : alphabet[below(alphabet.size())];
      const std::size_t way = below(4);
      if (way == 0) text[at] = byte;
      if (way == 1) text.insert(at, 1, byte);
      if (way == 2) text.erase(at, 1 + below(8));
      if (way == 3) text.insert(at, text.substr(below(text.size()), below(40)));
    }
    check_outcome(text);
  }
  SUCCEED();
}

TEST_CASE("words of a scene in random order end with a scene or one line") {
  std::mt19937 random(7);
  const char* words[] = {"sphere",     "{",      "}",       "center",  "0",         "1e9",
                         "-1",         "radius", "polygon", "points",  "3",         "vertex",
                         "(",          ")",      "*",       "-",       "cross",     "dot",
                         "ring",       "pow",    "sqrt",    "scale",   "rotate",    "\n",
                         "#define A ", "A",      "surface", "diffuse", "transform", "transform_pop",
                         "1e-9",       "patch",  "normal",  "texture", "checker",   "map",
                         "\"x.png\"",  "shine",  "light",   "type",    "spherical", "studio",
                         "project",    "flat",   "samples", "falloff", "at",        "ior"};
  for (int round = 0; round < 4000; ++round) {
    std::string text;
    for (std::size_t count = random() % 40; count > 0; --count) {
      text += words[random() % std::size(words)];
      if (random() % 4 != 0) text += ' ';
    }
    check_outcome(text);
  }
  SUCCEED();
}

TEST_CASE("hostile sizes end quickly with an error") {
  const std::string nested_brackets = "sphere { center " + std::string(100'000, '(');
  CHECK(error_of(nested_brackets) == "s.b:1: brackets more than 64 deep; nest less");
  CHECK(error_of(std::string(1'000'000, 'a')) ==
        "s.b:1: a word of 1000000 characters; a word has at most 128");
  std::string many;
  for (int i = 0; i < 65'535; ++i) many += "sphere{center 0 0 0 radius .1}\n";
  CHECK(error_of(many) == "s.b:65535: more than 65534 primitives; write fewer");
  std::string transforms;
  for (int i = 0; i < 101; ++i) transforms += "transform{}";
  CHECK(error_of(transforms) == "s.b:1: transforms more than 100 deep; write transform_pop");
  std::string lights;
  for (int i = 0; i < 257; ++i) lights += "light{center 0 0 1}";
  CHECK(error_of(lights) == "s.b:1: more than 256 lights; write fewer");
  std::string conditions;
  for (int i = 0; i < 1001; ++i) conditions += "#ifndef A\n";
  CHECK(error_of(conditions) == "s.b:1001: conditions more than 1000 deep; nest less");
  std::string macros;
  for (int i = 0; i < 10'001; ++i) macros += fmt::format("#define M{}\n", i);
  CHECK(error_of(macros) == "s.b:10001: more than 10000 macros; define less");
  const std::string signs = "sphere { center " + std::string(200'000, '-') + "1 0 0 radius 1 }";
  CHECK(error_of(signs) == "no error");
}

TEST_CASE("the polygon points of a scene are counted together") {
  std::string square = "polygon { points 4 vertex 0 0 0 vertex 1 0 0 vertex 1 1 0 vertex 0 1 0 }\n";
  CHECK(error_of(square + "polygon { points 999997 }") ==
        "s.b:2: more than 1000000 polygon points in the scene; write fewer");
}

TEST_CASE("a text past the limit is refused before it is read") {
  const std::string text((std::size_t{64} << 20) + 1, ' ');
  CHECK(error_of(text) == "s.b: too large; a scene has at most 64 MiB");
}

}  // namespace aspect
