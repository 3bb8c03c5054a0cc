// Every format against the same cube as a Bob scene: pictures, byte for byte.
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <catch2/catch.hpp>

#include "compiler/render/renderer.h"
#include "compiler/scene/mesh_reader.h"
#include "compiler/scene/scene_reader.h"
#include "tests/compiler/scene/mesh_samples.h"
#include "tests/compiler/scene/scene_samples.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

Scene read(const TemporaryFolder& folder, const SampleFile& file,
           const SceneReading& reading = {}) {
  Result<Scene> scene = read_scene(folder.write(file.name, file.bytes), reading);
  if (!scene) FAIL(scene.error());
  return std::move(scene).value();
}

void require_cube_pictures(const Scene& scene) {
  REQUIRE(scene.primitives.size() == 6);
  CHECK(scene.warnings.empty());
  const Renderer ours = std::move(Renderer::create(scene)).value();
  const Renderer bob = std::move(Renderer::create(bob_cube())).value();
  Picture one, other;
  for (const Vector3d& from : {Vector3d(1, 2, 3), {-2, 1, -.5}, {.3, -1, .2}, {-1, -1, -1}}) {
    ours.render(camera_at(scene.studio, from.normalized()), one);
    bob.render(camera_at(bob_cube().studio, from.normalized()), other);
    REQUIRE(one.rgb == other.rgb);
  }
  CHECK((scene.source_from_object.translation - kCubeCentre).norm() < 1e-12);
  const double half = std::get<Polygon>(scene.primitives[0].shape).vertices[0].cwiseAbs().x();
  CHECK(scene.source_from_object.scale * half == Approx(10));
}

}  // namespace

TEST_CASE("a cube in PLY, text or binary, coloured by face or vertex, looks like Bob's") {
  const TemporaryFolder folder;
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"})
    for (const bool of_vertices : {false, true})
      require_cube_pictures(read(folder, cube_ply(format, of_vertices)));
}

TEST_CASE("a cube in OFF, coloured by face or vertex, looks like Bob's") {
  const TemporaryFolder folder;
  for (const bool of_vertices : {false, true})
    require_cube_pictures(read(folder, cube_off(of_vertices)));
}

TEST_CASE("whole numbers are parts of 255, or of what their type holds, and others of 1") {
  const auto red_of = [](const std::string& bytes, const std::string& name) {
    const Result<Scene> scene = parse_mesh(bytes, name);
    if (!scene) FAIL(scene.error());
    return scene.value().surfaces.at(0).diffuse.x();
  };
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 ";
  CHECK(red_of(off + "51 0 0", "a.off") == Approx(.2));
  CHECK(red_of(off + "0.2 0 0", "a.off") == Approx(.2));
  const auto ply = [&](const std::string& type, const std::string& red) {
    std::string properties;
    for (const char* name : {"red", "green", "blue"})
      properties += "property " + type + " " + name + "\n";
    return red_of(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\n" +
            properties + "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 " + red + " 0 0\n",
        "a.ply");
  };
  CHECK(ply("uchar", "51") == Approx(.2));
  CHECK(ply("ushort", "13107") == Approx(.2));
  CHECK(ply("float", "0.2") == Approx(.2));
}

TEST_CASE("a cube in binary STL with the colours of either kind looks like Bob's") {
  const TemporaryFolder folder;
  for (const bool magics : {false, true})
    require_cube_pictures(read(folder, cube_binary_stl(magics)));
}

TEST_CASE("a cube in text STL is coloured by its solids' names or numbers") {
  const TemporaryFolder folder;
  SceneReading by_name, by_number;
  for (std::size_t k = 0; k < 6; ++k) {
    by_name.colours.by_name[cube_faces()[k].name] = cube_faces()[k].colour;
    by_number.colours.by_name[std::to_string(k)] = cube_faces()[k].colour;
  }
  for (const SceneReading& reading : {by_name, by_number}) {
    Scene scene = read(folder, cube_text_stl(), reading);
    REQUIRE(scene.warnings.size() == 1);
    CHECK(scene.warnings[0].find("holds no colours") != std::string::npos);
    scene.warnings.clear();
    require_cube_pictures(scene);
  }
  by_name.colours.by_name["lid"] = {1, 1, 1};
  const Result<Scene> wrong = read_scene(folder.path() / "cube.stl", by_name);
  REQUIRE_FALSE(wrong.ok());
  CHECK(wrong.error().find("has no part or material 'lid'; it has 0, 1") != std::string::npos);
}

TEST_CASE("a cube in OBJ, glTF and GLB has its materials' colours and looks like Bob's") {
  const TemporaryFolder folder;
  folder.write(cube_mtl().name, cube_mtl().bytes);
  for (const SampleFile& file : {cube_obj(), cube_gltf(), cube_glb()}) {
    INFO(file.name);
    require_cube_pictures(read(folder, file));
  }
}

TEST_CASE("a material's colour can be replaced by its name") {
  const TemporaryFolder folder;
  SceneReading reading;
  reading.colours.by_name["side3"] = {.5, .25, 0};
  const Scene scene = read(folder, cube_gltf(), reading);
  CHECK(scene.surfaces.at(3).diffuse == Vector3d(.5, .25, 0));
}

TEST_CASE("a cube in 3DS looks like Bob's: z stays upwards") {
  const TemporaryFolder folder;
  folder.write(cube_mtl().name, cube_mtl().bytes);
  const auto obj = folder.write(cube_obj().name, cube_obj().bytes);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(obj.string(), 0);
  REQUIRE(scene != nullptr);
  Assimp::Exporter exporter;
  const auto file = folder.path() / "CUBE.3DS";
  REQUIRE(exporter.Export(scene, "3ds", file.string(), 0) == aiReturn_SUCCESS);
  const Result<Scene> read_back = read_scene(file);
  if (!read_back) FAIL(read_back.error());
  require_cube_pictures(read_back.value());
}

TEST_CASE("a cube that Assimp wrote as glTF, GLB or OBJ looks like Bob's") {
  const TemporaryFolder folder;
  folder.write(cube_mtl().name, cube_mtl().bytes);
  const auto obj = folder.write(cube_obj().name, cube_obj().bytes);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(obj.string(), 0);
  REQUIRE(scene != nullptr);
  for (const auto& [format, name] :
       {std::pair{"gltf2", "made.gltf"}, {"glb2", "made.glb"}, {"obj", "made.obj"}}) {
    INFO(name);
    Assimp::Exporter exporter;
    const auto file = folder.path() / name;
    const unsigned triangulated = format[0] == 'o' ? 0u : unsigned{aiProcess_Triangulate};
    REQUIRE(exporter.Export(scene, format, file.string(), triangulated) == aiReturn_SUCCESS);
    const Result<Scene> read_back = read_scene(file);
    if (!read_back) FAIL(read_back.error());
    require_cube_pictures(read_back.value());
  }
}

TEST_CASE("a cube in DXF looks like Bob's, by layer, true colour and polyface") {
  const TemporaryFolder folder;
  for (const SampleFile& file : {cube_dxf_faces(true), cube_dxf_faces(false), cube_dxf_polyface()})
    require_cube_pictures(read(folder, file));
}

TEST_CASE("an unknown extension is refused with those that are known") {
  const Result<Scene> scene = read_scene("part.iges");
  REQUIRE_FALSE(scene.ok());
  CHECK(scene.error() ==
        "part.iges: unknown extension '.iges'; give one of .b .obj .ply .stl .gltf .glb .dxf .off "
        ".3ds .3mf .step .stp");
}

}  // namespace aspect
