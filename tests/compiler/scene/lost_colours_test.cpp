// Colours that other formats name and that are not there.
#include <catch2/catch.hpp>

#include "compiler/scene/scene_reader.h"
#include "compiler/scene/tds_materials.h"
#include "scene_samples.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using namespace std::string_literals;
using Catch::Contains;
using Catch::StartsWith;
using Eigen::Vector3d;

std::string chunk(unsigned id, const std::string& content) {
  std::string bytes;
  for (const auto& [value, count] : {std::pair<std::size_t, int>{id, 2}, {content.size() + 6, 4}})
    for (int k = 0; k < count; ++k) bytes += static_cast<char>(value >> 8 * k & 255u);
  return bytes + content;
}

std::string float_bytes(std::initializer_list<float> numbers) {
  std::string bytes;
  for (const float number : numbers)
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
  return bytes;
}

// A triangle of material "m" beside a definition of `defined`.
std::string tds(const std::string& defined, const std::string& map = "") {
  const std::string material = chunk(
      0xAFFF, chunk(0xA000, defined + "\0"s) + chunk(0xA020, chunk(0x0011, "\xff\0\0"s)) + map);
  const std::string vertices = chunk(0x4110, "\3\0"s + float_bytes({0, 0, 0, 1, 0, 0, 0, 1, 0}));
  const std::string uv = chunk(0x4140, "\3\0"s + float_bytes({0, 0, 1, 0, 0, 1}));
  const std::string faces = chunk(0x4120, "\1\0\0\0\1\0\2\0\0\0"s + chunk(0x4130, "m\0\1\0\0\0"s));
  return chunk(
      0x4D4D,
      chunk(0x3D3D, material + chunk(0x4000, "part\0"s + chunk(0x4100, vertices + faces + uv))));
}

void check_told(const std::filesystem::path& file, const std::string& line) {
  const Result<Scene> refused = read_scene(file);
  REQUIRE_FALSE(refused.ok());
  CHECK_THAT(refused.error(), StartsWith(line) && Contains("--missing-colour R,G,B"));
  SceneReading reading;
  reading.colours.missing = Vector3d(.25, .5, .75);
  const Result<Scene> scene = read_scene(file, reading);
  if (!scene) FAIL(scene.error());
  REQUIRE(scene.value().surfaces.size() == 1);
  CHECK(scene.value().surfaces[0].diffuse == Vector3d(.25, .5, .75));
  CHECK(scene.value().missing_colours.size() == 1);
}

}  // namespace

TEST_CASE("a material that a 3DS file does not define is told") {
  const TemporaryFolder folder;
  const auto file = folder.write("a.3ds", tds("other"));
  check_told(file, file.string() + ": material 'm' is not defined");
  const Result<Scene> whole = read_scene(folder.write("a.3ds", tds("m")));
  if (!whole) FAIL(whole.error());
  CHECK(whole.value().surfaces.at(0).diffuse == Vector3d(1, 0, 0));
}

TEST_CASE("a picture that a 3DS file names and that is not there is told") {
  const TemporaryFolder folder;
  const auto file =
      folder.write("a.3ds", tds("m", chunk(0xA200, chunk(0xA300, "C:\\maps\\none.png\0"s))));
  check_told(file, file.string() + ": texture 'C:\\maps\\none.png' is not there");
}

TEST_CASE("chunks of a 3DS file that are cut off or lie about their sizes end the search") {
  const std::string whole = tds("other");
  CHECK(undefined_tds_materials(whole) == std::vector<std::string>{"m"});
  for (std::size_t length = 0; length < whole.size(); ++length)
    CHECK(undefined_tds_materials(whole.substr(0, length)).empty());
  for (std::size_t k = 0; k < whole.size(); ++k) {
    std::string changed = whole;
    changed[k] = '\xff';
    CHECK(undefined_tds_materials(changed).size() <= 1);
  }
}

TEST_CASE("a place in a colour map that an OFF file does not hold is told with its line") {
  const TemporaryFolder folder;
  const auto file = folder.write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 7\n");
  check_told(file, file.string() + ":6: colour '7' is a place in a colour map");
}

TEST_CASE("an OFF file that promises colours of vertices and has some is refused with the line") {
  const TemporaryFolder folder;
  const auto file =
      folder.write("a.off", "COFF\n3 1 0\n0 0 0 255 0 0\n1 0 0\n0 1 0 255 0 0\n3 0 1 2\n");
  const Result<Scene> scene = read_scene(file);
  REQUIRE_FALSE(scene.ok());
  CHECK_THAT(scene.error(), StartsWith(file.string() + ":4: a vertex without the colour"));
}

TEST_CASE("faces without a colour among others are counted") {
  const TemporaryFolder folder;
  folder.write("a.mtl", "newmtl red\nKd 1 0 0\n");
  const std::string corners = float_bytes({0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0});
  const auto file_of = [&](const std::string& name) {
    if (name == "a.obj")
      return "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 4\nusemtl red\nf 1 2 3\n"s;
    if (name == "a.off")
      return "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 3\n3 0 1 2 1.0 0 0\n"s;
    return std::string(80, ' ') + "\2\0\0\0"s + corners + "\0\0"s +
           float_bytes({0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1}) + "\0\xfc"s;
  };
  for (const char* name : {"a.obj", "a.off", "a.stl"}) {
    INFO(name);
    const Result<Scene> scene = read_scene(folder.write(name, file_of(name)));
    if (!scene) FAIL(scene.error());
    CHECK(scene.value().surfaces.size() == 2);
    REQUIRE(scene.value().warnings.size() == 1);
    CHECK_THAT(scene.value().warnings[0], Contains("1 of 2 faces have no colour; they are grey"));
  }
}

}  // namespace aspect
