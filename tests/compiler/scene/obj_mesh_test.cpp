// OBJ and MTL: colours as their specification has them, and every colour that is lost told with
// its place.
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>

#include "compiler/scene/mesh_reader.h"
#include "compiler/scene/scene_reader.h"
#include "mesh_samples.h"
#include "scene_samples.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Contains;
using Catch::StartsWith;
using Eigen::Vector3d;

const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
const std::string kRedLibrary = "newmtl red\nKd 0.8 0.1 0.1\n";

std::string obj_with(const std::string& head) {
  return head + kCorners + "usemtl red\nf 1/1 2/2 3/3\n";
}

Scene scene_at(const std::filesystem::path& file, const SceneReading& reading = {}) {
  Result<Scene> scene = read_scene(file, reading);
  if (!scene) FAIL(scene.error());
  return std::move(scene).value();
}

Vector3d only_colour(const Scene& scene) {
  REQUIRE(scene.surfaces.size() == 1);
  return scene.surfaces[0].diffuse;
}

std::string refusal(const std::filesystem::path& file) {
  const Result<Scene> scene = read_scene(file);
  return scene.ok() ? "no error" : scene.error();
}

std::string blue_png() {
  std::vector<std::uint8_t> png;
  cv::imencode(".png", cv::Mat(2, 2, CV_8UC3, cv::Scalar(255, 51, 0)), png);
  return {png.begin(), png.end()};
}

// Refused with this line, read with a stand-in that all of it then shows, and told once.
void check_told(const std::filesystem::path& file, const std::string& place,
                const std::string& what) {
  INFO(what);
  CHECK_THAT(refusal(file), StartsWith(place) && Contains(what) &&
                                Contains(", or go on with --missing-colour R,G,B"));
  SceneReading reading;
  reading.colours.missing = Vector3d(.25, .5, .75);
  const Scene scene = scene_at(file, reading);
  CHECK(only_colour(scene) == Vector3d(.25, .5, .75));
  REQUIRE(scene.missing_colours.size() == 1);
  CHECK_THAT(line_of(scene.missing_colours[0]), StartsWith(place) && Contains(what));
}

}  // namespace

TEST_CASE("a library that is not there is told with its line") {
  const TemporaryFolder folder;
  const auto file = folder.write("part.obj", "# by hand\n" + obj_with("mtllib none.mtl\n"));
  check_told(file, file.string() + ":2:", "mtllib 'none.mtl' is not there");
  folder.write("two.mtl", "newmtl green\nKd 0 1 0\n");
  const auto two = folder.write("two.obj", obj_with("mtllib two.mtl none.mtl\n"));
  check_told(two, two.string() + ":1:", "mtllib 'none.mtl' is not there");
}

TEST_CASE("a library is found in spite of its case, another system's folders or a mark in front") {
  const TemporaryFolder folder;
  folder.write("part.mtl", kRedLibrary);
  folder.write("my part.mtl", kRedLibrary);
  folder.write("sub/deep.mtl", "\xEF\xBB\xBF" + kRedLibrary);
  for (const std::string name :
       {"part.mtl", "PART.MTL", "Part.mtl", "C:\\models\\part.mtl", "\\\\host\\share\\Part.MTL",
        "/home/other/part.mtl", ".\\part.mtl", "sub\\deep.mtl", "Sub/Deep.mtl", "my part.mtl",
        "\"my part.mtl\"", "part.mtl sub/deep.mtl"}) {
    INFO(name);
    for (const std::string mark : {"", "\xEF\xBB\xBF"})
      CHECK(only_colour(scene_at(folder.write(
                "part.obj", mark + obj_with("mtllib " + name + "\n")))) == Vector3d(.8, .1, .1));
  }
  // What was guessed is said.
  const Scene guessed = scene_at(folder.write("part.obj", obj_with("mtllib Part.mtl\n")));
  REQUIRE(guessed.warnings.size() == 1);
  CHECK_THAT(guessed.warnings[0], Contains("mtllib 'Part.mtl' of line 1 is taken to be"));
}

TEST_CASE("lines end in line feeds, carriage returns or both, in the file and its library") {
  const TemporaryFolder folder;
  const auto with_ends = [](std::string text, const std::string& end) {
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size())
      text.replace(at, 1, end);
    return text;
  };
  for (const std::string end : {"\n", "\r", "\r\n"}) {
    folder.write("part.mtl", with_ends(kRedLibrary, end));
    const auto file =
        folder.write("part.obj", with_ends(obj_with("mtllib part.mtl\nvt nan(ind) 0\n"), end));
    CHECK(only_colour(scene_at(file)) == Vector3d(.8, .1, .1));
  }
}

TEST_CASE("two files whose names differ in case alone are not chosen between") {
  const TemporaryFolder folder;
  folder.write("part.mtl", kRedLibrary);
  folder.write("PART.mtl", kRedLibrary);
  CHECK_THAT(refusal(folder.write("part.obj", obj_with("mtllib Part.mtl\n"))),
             Contains("mtllib 'Part.mtl' is not there"));
}

TEST_CASE("a material that no library has is told with its line") {
  const TemporaryFolder folder;
  folder.write("part.mtl", "newmtl rod\nKd 1 0 0\n");
  const auto file = folder.write("part.obj", obj_with("mtllib part.mtl\n"));
  check_told(file, file.string() + ":8:", "usemtl 'red' is in no library");
  CHECK_THAT(refusal(file), Contains("the nearest one there is 'rod'"));
  const auto bare = folder.write("bare.obj", obj_with(""));
  check_told(bare, bare.string() + ":7:", "usemtl 'red' is in no library");
  CHECK_THAT(refusal(bare), Contains("name the library by mtllib"));
  // Several materials, one fault.
  const auto two = folder.write("two.obj", obj_with("") + "usemtl blue\nf 3 2 1\n");
  check_told(two, two.string() + ":7:", "usemtl 'red' is in no library, since mtllib names none");
}

TEST_CASE("a material that no face shows may be missing, and a library that nothing needs") {
  const TemporaryFolder folder;
  folder.write("part.mtl", kRedLibrary);
  const Scene scene = scene_at(
      folder.write("part.obj", obj_with("mtllib part.mtl\nmtllib none.mtl\nusemtl unused\n")));
  CHECK(only_colour(scene) == Vector3d(.8, .1, .1));
  REQUIRE(scene.warnings.size() == 1);
  CHECK_THAT(scene.warnings[0], Contains("mtllib 'none.mtl' of line 2 is not there"));
}

TEST_CASE("a part that is given a colour by its number lacks none") {
  const TemporaryFolder folder;
  SceneReading reading;
  reading.colours.by_name["0"] = {1, .5, 0};
  const auto file = folder.write("part.obj", obj_with("mtllib none.mtl\n"));
  const Scene scene = scene_at(file, reading);
  CHECK(only_colour(scene) == Vector3d(1, .5, 0));
  CHECK(scene.missing_colours.empty());
  // Two parts lack one; one of them is given.
  folder.write("part.obj", obj_with("mtllib none.mtl\n") + "usemtl blue\nf 3 2 1\n");
  CHECK_FALSE(read_scene(file, reading).ok());
}

TEST_CASE("a picture that is not there or no picture is told with the library's line") {
  const TemporaryFolder folder;
  const auto mtl = folder.write("part.mtl", kRedLibrary + "map_Kd tex.png\n");
  const auto file = folder.write("part.obj", obj_with("mtllib part.mtl\n"));
  check_told(file, mtl.string() + ":3:", "map_Kd 'tex.png' is not there");
  folder.write("tex.png", "not a picture");
  check_told(file, mtl.string() + ":3:", "map_Kd 'tex.png' is no picture that is read");
}

TEST_CASE("a picture is found with backslashes, in another case, with options and spaces") {
  const TemporaryFolder folder;
  folder.write("tex.png", blue_png());
  folder.write("maps/my tex.png", blue_png());
  const auto file = folder.write("part.obj", obj_with("mtllib part.mtl\n"));
  for (const std::string name :
       {"tex.png", "C:\\textures\\tex.png", "maps\\my tex.png", "TEX.PNG", "-s 2 2 1 tex.png",
        "-o 0.5 tex.png", "-bm 1 -clamp on maps/my tex.png"}) {
    INFO(name);
    folder.write("part.mtl", "newmtl red\nmap_Kd " + name + "\n");
    CHECK(only_colour(scene_at(file)).isApprox(Vector3d(0, .2, 1)));
  }
}

TEST_CASE("faces without texture coordinates do not lose their picture without a word") {
  const TemporaryFolder folder;
  folder.write("tex.png", blue_png());
  folder.write("part.mtl", "newmtl red\nmap_Kd tex.png\n");
  const auto file =
      folder.write("part.obj", "mtllib part.mtl\n" + kCorners + "usemtl red\nf 1 2 3\n");
  check_told(file, file.string() + ":9:", "a face without texture coordinates");
}

TEST_CASE("Kd is r g b, one number for all three, or CIE XYZ; a spectral curve is told") {
  const TemporaryFolder folder;
  const auto file = folder.write("part.obj", obj_with("mtllib part.mtl\n"));
  const auto colour = [&](const std::string& kd) {
    folder.write("part.mtl", "newmtl red\n" + kd + "\n");
    return only_colour(scene_at(file));
  };
  CHECK(colour("Kd 0.6 0.5 0.4") == Vector3d(.6, .5, .4));
  CHECK(colour("Kd 0.6") == Vector3d(.6, .6, .6));
  CHECK(colour("  Kd\t0.6 # grey") == Vector3d(.6, .6, .6));
  CHECK(colour("Kd 0.6 0.5 0.4\nKd 1 0 0") == Vector3d(1, 0, 0));
  // D65, the white of sRGB, and sRGB's red.
  CHECK(colour("Kd xyz 0.9505 1 1.089").isApprox(Vector3d(1, 1, 1), 1e-3));
  CHECK(colour("Kd xyz 0.4124 0.2126 0.0193").isApprox(Vector3d(1, 0, 0), 1e-3));
  const auto mtl = folder.write("part.mtl", "newmtl red\nKd spectral red.rfl 1\n");
  check_told(file, mtl.string() + ":2:", "Kd of 'red' is a spectral curve");
  for (const std::string wrong : {"Kd", "Kd 1 2", "Kd red"}) {
    folder.write("part.mtl", "newmtl red\n" + wrong + "\n");
    CHECK_THAT(refusal(file), StartsWith(mtl.string() + ":2: "));
  }
}

TEST_CASE("vertices of which some have colours and some not are an error") {
  const TemporaryFolder folder;
  const auto file = folder.write("part.obj",
                                 "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0\nv 0 0 1 1 0 0\n"
                                 "f 1 2 4\nf 1 2 3\n");
  CHECK_THAT(refusal(file),
             StartsWith(file.string() + ":6: ") && Contains("some have a colour and some not"));
  // The same where whole faces differ and no material colours the others.
  folder.write("part.obj",
               "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 0 1 1 0 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\n"
               "f 1 2 3\nf 4 5 6\n");
  CHECK_THAT(refusal(file), StartsWith(file.string() + ":8: ") && Contains("have no colour"));
  // A vertex of no face needs none.
  folder.write("part.obj", "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 0 1 1 0 0\nv 9 9 9\nf 1 2 3\n");
  CHECK(only_colour(scene_at(file)) == Vector3d(1, 0, 0));
}

TEST_CASE("colours of vertices are parts of 1, or of 255 where one is above 1") {
  const TemporaryFolder folder;
  const auto colour = [&](const std::string& rgb) {
    return only_colour(scene_at(folder.write(
        "part.obj", "v 0 0 0 " + rgb + "\nv 1 0 0 " + rgb + "\nv 0 1 0 " + rgb + "\nf 1 2 3\n")));
  };
  CHECK(colour("0.2 0.4 0.6").isApprox(Vector3d(.2, .4, .6)));
  CHECK(colour("51 102 153").isApprox(Vector3d(.2, .4, .6)));
}

TEST_CASE("faces are those that Assimp reads, whatever the dress of the file") {
  const TemporaryFolder folder;
  folder.write(cube_mtl().name, cube_mtl().bytes);
  const std::string square = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nvn 0 0 1\nvt 0 0\n";
  for (const std::string& text :
       {cube_obj().bytes, square + "f 1 2 3 4\n", square + "f 1/1 2/1 3/1\nf 1//1 3//1 4//1\n",
        square + "o one\nf -4/-1/-1 -3/1/1 \\\n-2/1/1\ng two\nf 1/1/1 3/1/1 4/1/1\n",
        square + "s 1\nl 1 2\nf 1 2 3\r\nf 1 3 4\r\n"}) {
    const auto file = folder.write("part.obj", text);
    const Result<ColouredMesh> ours = read_coloured_mesh(file);
    if (!ours) FAIL(ours.error());
    Assimp::Importer importer;
    const aiScene* scene =
        importer.ReadFile(file.string(), aiProcess_Triangulate | aiProcess_PreTransformVertices |
                                             aiProcess_SortByPType);
    INFO(text << importer.GetErrorString());
    REQUIRE(scene != nullptr);
    Vector3d area = Vector3d::Zero(), their_area = Vector3d::Zero();
    std::size_t triangles = 0;
    const auto area_of = [](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
      return (b - a).cross(c - a).cwiseAbs().eval();
    };
    for (const auto& [a, b, c] : ours.value().triangles)
      area += area_of(ours.value().vertices[a], ours.value().vertices[b], ours.value().vertices[c]);
    for (unsigned m = 0; m < scene->mNumMeshes; ++m)
      for (unsigned f = 0; f < scene->mMeshes[m]->mNumFaces; ++f) {
        const aiFace& face = scene->mMeshes[m]->mFaces[f];
        if (face.mNumIndices != 3) continue;
        const auto at = [&](unsigned k) {
          const aiVector3D& v = scene->mMeshes[m]->mVertices[face.mIndices[k]];
          return Vector3d(double(v.x), double(v.y), double(v.z));
        };
        their_area += area_of(at(0), at(1), at(2));
        ++triangles;
      }
    CHECK(ours.value().triangles.size() == triangles);
    CHECK(area.isApprox(their_area));
    CHECK(area.sum() > 0);
  }
}

TEST_CASE("indices that are not there are told with their line") {
  const TemporaryFolder folder;
  for (const std::string face :
       {"f 1 2 4", "f 1 2 0", "f 1 2 -4", "f 1/4 2/1 3/1", "f 1 2 x", "f 1 2 99999999999"}) {
    INFO(face);
    const auto file = folder.write("part.obj", kCorners + face + "\n");
    CHECK_THAT(refusal(file), StartsWith(file.string() + ":7: "));
  }
}

}  // namespace aspect
