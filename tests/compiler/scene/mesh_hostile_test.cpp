// Files that are cut off, changed or lie about their sizes: one line, no crash.
#include <catch2/catch.hpp>
#include <csignal>
#include <random>

#include "compiler/scene/isolated_reader.h"
#include "compiler/scene/mesh_reader.h"
#include "compiler/scene/scene_reader.h"
#include "tests/compiler/scene/mesh_samples.h"
#include "tests/compiler/scene/scene_samples.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

std::vector<SampleFile> own_formats() {
  return {cube_ply("ascii", true),
          cube_ply("binary_big_endian", false),
          cube_off(true),
          cube_binary_stl(true),
          cube_dxf_faces(true),
          cube_dxf_polyface(),
          cube_obj(),
          cube_gltf(),
          cube_glb()};
}

void require_scene_or_line(const Result<Scene>& scene, const std::string& name) {
  if (scene.ok()) return;
  REQUIRE(scene.error().find('\n') == std::string::npos);
  REQUIRE(scene.error().find(name) == 0);
}

std::string error_of_bytes(const std::string& bytes, const std::string& name) {
  const Result<Scene> scene = parse_mesh(bytes, name);
  return scene.ok() ? "no error" : scene.error();
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("files cut off anywhere are read or refused in one line") {
  for (const SampleFile& file : own_formats()) {
    int refused = 0;
    for (std::size_t length = 0; length < file.bytes.size(); length += 3) {
      const Result<Scene> scene = parse_mesh(file.bytes.substr(0, length), file.name);
      require_scene_or_line(scene, file.name);
      refused += !scene.ok();
    }
    CHECK(refused > 50);
  }
}

TEST_CASE("files with bytes changed at random are read or refused in one line") {
  std::mt19937 random(5);
  for (const SampleFile& file : own_formats())
    for (int round = 0; round < 400; ++round) {
      std::string bytes = file.bytes;
      for (int k = 0; k < 1 + round % 8; ++k)
        bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
      require_scene_or_line(parse_mesh(bytes, file.name), file.name);
    }
}

TEST_CASE("what goes through Assimp is read or refused in one line") {
  const TemporaryFolder folder;
  folder.write(cube_mtl().name, cube_mtl().bytes);
  std::mt19937 random(6);
  for (const SampleFile& file : {cube_obj(), cube_gltf(), cube_glb(), cube_text_stl()})
    for (int round = 0; round < 12; ++round) {
      std::string bytes = file.bytes;
      if (round % 2 == 0)
        bytes.resize(bytes.size() * static_cast<std::size_t>(round) / 12);
      else
        bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
      const auto path = folder.write(file.name, bytes);
      require_scene_or_line(read_scene(path), path.string());
    }
}

TEST_CASE("sizes that a file only claims are not believed") {
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex ";
  const std::string xyz = "\nproperty float x\nproperty float y\nproperty float z\n";
  CHECK(holds(error_of_bytes(ply + "99999999999999" + xyz + "end_header\n", "a.ply"), "a.ply:3: "));
  CHECK(
      holds(error_of_bytes(ply + "14000000" + xyz + "end_header\n1 2 3\n", "a.ply"), "ends where"));
  CHECK(
      holds(error_of_bytes("OFF\n4000000 4000000 0\n", "a.off"), "ends where a vertex should be"));
  CHECK(holds(error_of_bytes("OFF\n99999999999 1 0\n", "a.off"), "is not a whole number within"));
  std::string stl(84, '\xff');
  CHECK(holds(error_of_bytes(stl, "a.stl"), "says 4294967295 faces, but holds 0"));
  CHECK(holds(error_of_bytes("", "a.stl"), "too short"));
  CHECK(holds(error_of_bytes("OFF\n1 1 0\nnan 0 0\n", "a.off"), "a.off:3: 'nan' is not a finite"));
  CHECK(holds(error_of_bytes("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off"),
              "a.off:6: vertex 3, but there are 3"));
  CHECK(holds(error_of_bytes("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "a.off"), "'-1'"));
}

TEST_CASE("missing, empty and wrong files are refused in one line") {
  const TemporaryFolder folder;
  for (const char* name :
       {"a.obj", "a.ply", "a.stl", "a.gltf", "a.glb", "a.dxf", "a.off", "a.3ds", "a.3mf"}) {
    const auto path = folder.path() / name;
    const Result<Scene> missing = read_scene(path);
    REQUIRE_FALSE(missing.ok());
    CHECK(missing.error() == path.string() + ": no such file; check the path");
    folder.write(name, "");
    const Result<Scene> empty = read_scene(path);
    REQUIRE_FALSE(empty.ok());
    CHECK(empty.error() == path.string() + ": is empty; export it again");
    folder.write(name, "What a day!\n");
    const Result<Scene> wrong = read_scene(path);
    REQUIRE_FALSE(wrong.ok());
    require_scene_or_line(wrong, path.string());
  }
}

TEST_CASE("a reader that crashes, throws or runs out of memory is an error and no more") {
  const auto error = [](const std::function<ColouredMesh()>& read) {
    try {
      read_isolated(read);
    } catch (const MeshError& failure) {
      return std::string(failure.what());
    }
    return std::string("no error");
  };
  CHECK(holds(error([]() -> ColouredMesh {
                std::raise(SIGKILL);
                return {};
              }),
              "breaks its reader"));
  CHECK(holds(error([]() -> ColouredMesh { throw MeshError("is odd"); }), "is odd"));
  try {
    read_isolated([]() -> ColouredMesh { throw MeshError("is odd", 7, "a.mtl"); });
    FAIL("no error");
  } catch (const MeshError& failure) {
    CHECK((failure.line() == 7 && failure.file() == "a.mtl"));
  }
  CHECK(holds(error([]() -> ColouredMesh { throw std::bad_alloc(); }), "cannot be read"));
  CHECK(error([] { return ColouredMesh{}; }) == "no error");
}

TEST_CASE("a mesh comes back whole from a process of its own") {
  ColouredMesh sent;
  sent.parts = {{"a", "b"}, {"", "c"}};
  sent.warnings = {"one", "two"};
  sent.missing = {{"a.mtl", 3, "what", "cure", {0, 1}}, {"", 0, "else", "", {}}};
  for (int k = 0; k < 100000; ++k) add_vertex(sent, {k * .1, k * .2, -k * .3});
  for (std::uint32_t k = 0; k + 2 < 100000; ++k)
    add_face(sent, std::array{k, k + 1, k + 2}, {k * 1e-5, .5, 1}, k % 2);
  const ColouredMesh got = read_isolated([&] { return sent; });
  CHECK((got.vertices == sent.vertices && got.triangles == sent.triangles));
  CHECK((got.colours == sent.colours && got.part_of == sent.part_of));
  CHECK(got.warnings == sent.warnings);
  REQUIRE(got.missing.size() == 2);
  CHECK(line_of(got.missing[0]) == "a.mtl:3: what");
  CHECK(
      (got.missing[0].cure == "cure" && got.missing[0].parts == std::vector<std::uint32_t>{0, 1}));
  CHECK((got.missing[1].what == "else" && got.missing[1].parts.empty()));
  REQUIRE(got.parts.size() == 2);
  CHECK((got.parts[0].name == "a" && got.parts[0].material == "b"));
  CHECK((got.parts[1].name.empty() && got.parts[1].material == "c"));
}

}  // namespace aspect
