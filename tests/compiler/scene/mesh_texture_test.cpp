#include "compiler/scene/mesh_texture.h"

#include <catch2/catch.hpp>
#include <numbers>
#include <opencv2/imgcodecs.hpp>

#include "compiler/render/renderer.h"
#include "compiler/scene/scene_reader.h"
#include "tests/compiler/scene/mesh_samples.h"
#include "tests/compiler/scene/scene_samples.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

constexpr int kSize = 200;

// Green left, blue right, a red disc of a quarter of the width in the upper left quarter.
std::string disc_png() {
  cv::Mat picture(kSize, kSize, CV_8UC3);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const bool disc = std::hypot(x + .5 - 50, y + .5 - 50) < 25;
      picture.at<cv::Vec3b>(y, x) = disc            ? cv::Vec3b(0, 0, 255)
                                    : x < kSize / 2 ? cv::Vec3b(0, 255, 0)
                                                    : cv::Vec3b(255, 0, 0);
    }
  std::vector<std::uint8_t> png;
  cv::imencode(".png", picture, png);
  return {png.begin(), png.end()};
}

// A square in the plane z = 0 with the texture upright seen from +z, y upwards.
std::string textured_obj() {
  return "mtllib m.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
         "usemtl tex\nf 1/1 2/2 3/3 4/4\n";
}

std::string textured_gltf() {
  std::string buffer;
  const auto add = [&](float value) {
    buffer.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (const auto& [x, y] :
       {std::pair{-1.f, -1.f}, {1.f, -1.f}, {1.f, 1.f}, {-1.f, -1.f}, {1.f, 1.f}, {-1.f, 1.f}})
    add(x), add(y), add(0);
  for (const auto& [u, v] :
       {std::pair{0.f, 1.f}, {1.f, 1.f}, {1.f, 0.f}, {0.f, 1.f}, {1.f, 0.f}, {0.f, 0.f}})
    add(u), add(v);
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}],)"
         R"("materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],)"
         R"("textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,)" +
         base64(disc_png()) +
         R"("}],"accessors":[{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3",)"
         R"("min":[-1,-1,0],"max":[1,1,0]},{"bufferView":1,"componentType":5126,"count":6,)"
         R"("type":"VEC2"}],"bufferViews":[{"buffer":0,"byteLength":72},{"buffer":0,)"
         R"("byteOffset":72,"byteLength":48}],"buffers":[{"byteLength":120,)"
         R"("uri":"data:application/octet-stream;base64,)" +
         base64(buffer) + "\"}]}";
}

struct Seen {
  int red = 0, green = 0, blue = 0, other = 0, wrong_side = 0;
};

Seen seen_from_above(Scene scene) {
  scene.studio.up = {0, 1, 0};
  Picture picture;
  std::move(Renderer::create(scene)).value().render(camera_at(scene.studio, {0, 0, 1}), picture);
  Seen seen;
  for (std::size_t k = 0; k < picture.surface.size(); ++k) {
    if (picture.surface[k] == 0) continue;
    const std::array<int, 3> rgb = {picture.rgb[3 * k], picture.rgb[3 * k + 1],
                                    picture.rgb[3 * k + 2]};
    const bool left = k % 512 < 256, upper = k / 512 < 256;
    if (rgb == std::array{255, 0, 0})
      ++seen.red, seen.wrong_side += !left || !upper;
    else if (rgb == std::array{0, 255, 0})
      ++seen.green;
    else if (rgb == std::array{0, 0, 255})
      ++seen.blue, seen.wrong_side += left;
    else
      ++seen.other;
  }
  return seen;
}

}  // namespace

TEST_CASE("a texture's pieces have its colours alone, its areas and its places") {
  const TemporaryFolder folder;
  folder.write("disc.png", disc_png());
  folder.write("m.mtl", "newmtl tex\nKd 0 0 0\nmap_Kd disc.png\n");
  folder.write("square.obj", textured_obj());
  folder.write("square.gltf", textured_gltf());
  for (const char* name : {"square.obj", "square.gltf"}) {
    INFO(name);
    Result<Scene> scene = read_scene(folder.path() / name);
    if (!scene) FAIL(scene.error());
    CHECK(scene.value().warnings.empty());
    CHECK(scene.value().surfaces.size() == 3);
    // Green, blue, red, and what the jagged border cuts off.
    CHECK(scene.value().primitives.size() >= 3);
    CHECK(scene.value().primitives.size() <= 6);
    const Seen seen = seen_from_above(std::move(scene).value());
    const double all = seen.red + seen.green + seen.blue + seen.other;
    CHECK(all > 50000);
    CHECK(seen.other == 0);
    CHECK(seen.wrong_side < .01 * all);
    CHECK(seen.red / all == Approx(std::numbers::pi / 64).epsilon(.03));
    CHECK(seen.blue / all == Approx(.5).epsilon(.01));
  }
}

TEST_CASE("a texture repeats, and (0, 0) is its lower left corner") {
  const MeshTexture texture{2, 2, {1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4}};
  const auto at = [&](double u, double v) { return std::lround(255 * texture.at({u, v}).x()); };
  CHECK(at(.25, .25) == 3);
  CHECK(at(.75, .25) == 4);
  CHECK(at(.25, .75) == 1);
  CHECK(at(-.25, 1.75) == 2);
  CHECK(at(1, 1) == 3);
}

}  // namespace aspect
