// Textures as they are read: their patterns, their frames, and the files of maps.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>
#include <string>

#include "compiler/scene/bob_reader.h"
#include "compiler/scene/texture_map.h"
#include "tests/compiler/scene/scene_samples.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

constexpr const char* kBall = "sphere { center 0 0 0 radius .1 }";

std::string tiles() {
  const auto file = std::filesystem::path(ASPECT_SOURCE_DIR) / "tests/data/scenes/tiles.png";
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  REQUIRE(bytes.str().size() > 100);
  return bytes.str();
}

const Texture& texture_of(const Scene& scene) {
  REQUIRE(scene.surfaces.at(0).texture != nullptr);
  return *scene.surfaces[0].texture;
}

}  // namespace

TEST_CASE("a checker is white and black, or of the two colours it names") {
  const Scene plain = scene_of(std::string("surface { texture { checker } }") + kBall);
  const auto& white_black = std::get<Checker>(texture_of(plain).pattern).colors;
  CHECK(white_black[0] == Eigen::Vector3d(1, 1, 1));
  CHECK(white_black[1] == Eigen::Vector3d(0, 0, 0));
  const Scene named =
      scene_of(std::string("surface { texture { checker .1 .2 .3 (.4 .5 .6) } }") + kBall);
  const auto& colors = std::get<Checker>(texture_of(named).pattern).colors;
  CHECK(colors[0] == Eigen::Vector3d(.1, .2, .3));
  CHECK(colors[1] == Eigen::Vector3d(.4, .5, .6));
}

TEST_CASE("a pattern is moved by its steps in their order, and by the transform around it") {
  const Scene scene = scene_of(
      std::string("transform { translate 0 0 1 } surface { texture { checker scale 2 translate 3 "
                  "0 0 } }") +
      kBall + " transform_pop");
  const Texture& texture = texture_of(scene);
  CHECK((texture.frame_from_object * Eigen::Vector3d(1, 2, 3)).isApprox(Eigen::Vector3d(1, 2, 2)));
  CHECK((texture.pattern_from_frame * Eigen::Vector3d(5, 2, 4)).isApprox(Eigen::Vector3d(1, 1, 2)));
}

TEST_CASE("a map is found beside the file that names it or on the include path") {
  const TemporaryFolder folder;
  const std::string use = "surface { texture { map \"tiles.png\" } } " + std::string(kBall);
  folder.write("parts/tiles.png", tiles());
  folder.write("parts/tiled.bo", "#define TILED " + use);
  const auto beside = read_bob(folder.write("beside.b", "#include parts/tiled.bo\nTILED"));
  REQUIRE(beside.ok());
  const auto on_path = read_bob(folder.write("on_path.b", use), {folder.path() / "parts"});
  REQUIRE(on_path.ok());
  for (const auto* scene : {&beside.value(), &on_path.value()}) {
    const TextureMap& map = *std::get<ImageMap>(texture_of(*scene).pattern).picture;
    CHECK(map.width_px == 8);
    CHECK(map.height_px == 8);
    CHECK(map.rgb[0] == 230);
    CHECK(map.rgb[1] == 60);
    CHECK(map.rgb[2] == 80);
    CHECK(map.rgb[3 * 63] == 90);
  }
  CHECK_FALSE(read_bob(folder.write("missing.b", use)).ok());
  const auto both = folder.write(
      "parts/both.b", "surface { texture { map \"tiles.png\"\nchecker } } " + std::string(kBall));
  CHECK(error_of_file(both) ==
        both.string() + ":1: a texture of both checker and map; write one of them");
}

TEST_CASE("a scene's source changes with the pixels of its maps") {
  const TemporaryFolder folder;
  const auto file =
      folder.write("map.b", "surface { texture { map \"tiles.png\" } } " + std::string(kBall));
  folder.write("tiles.png", tiles());
  const std::string source = read_bob(file).value().source;
  CHECK(read_bob(file).value().source == source);
  TextureMap map = decode_png(tiles(), 64).value();
  const std::uint64_t digest = digest_of(map);
  ++map.rgb.back();
  CHECK(digest_of(map) != digest);
  CHECK(source.find("[") != std::string::npos);
}

TEST_CASE("a damaged picture is refused with one line, wherever it is cut or changed") {
  const std::string bytes = tiles();
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const auto map = decode_png(std::string_view(bytes).substr(0, length), 64);
    if (map.ok()) {
      CHECK(length + 12 >= bytes.size());  // only the empty last chunk may be missing
    } else {
      CHECK(map.error().find('\n') == std::string::npos);
    }
  }
  for (std::size_t k = 0; k < bytes.size(); ++k)
    for (const char mask : {'\x01', '\x80', '\xff'}) {
      std::string changed = bytes;
      changed[k] = static_cast<char>(changed[k] ^ mask);
      const auto map = decode_png(changed, 64);
      if (map.ok()) CHECK(map.value().rgb.size() == 192);
    }
}

TEST_CASE("a picture with more pixels than are left is refused before they are read") {
  const auto map = decode_png(tiles(), 63);
  REQUIRE_FALSE(map.ok());
  CHECK(map.error() == "8 x 8 pixels, 63 are left for maps; write a smaller picture");
}

TEST_CASE("a file that is no picture is an error of the line that names it") {
  const TemporaryFolder folder;
  folder.write("text.png", "not a picture");
  const auto file = folder.write("map.b", "\nsurface { texture { map \"text.png\" } }");
  const std::string error = error_of_file(file);
  INFO(error);
  CHECK(error.find(file.string() + ":2: ") == 0);
  CHECK(error.find("text.png: no PNG picture (") != std::string::npos);
}

}  // namespace aspect
