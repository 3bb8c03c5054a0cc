// Colours and names of files that OpenCASCADE writes.
#include <catch2/catch.hpp>
#include <map>

#include "compiler/scene/mesh_reader.h"
#include "compiler/scene/scene_reader.h"
#include "tests/compiler/step/step_samples.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

ColouredMesh mesh_of(const std::filesystem::path& file) {
  Result<ColouredMesh> mesh = read_coloured_mesh(file);
  if (!mesh) FAIL(mesh.error());
  return std::move(mesh).value();
}

// Of the triangles of a part.
Vector3d colour_of(const ColouredMesh& mesh, std::uint32_t part) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.part_of[t] == part) return mesh.colours[t];
  FAIL("part " << part << " has no triangle");
  return {};
}

// The middle of the box around a part.
Vector3d middle_of(const ColouredMesh& mesh, std::uint32_t part) {
  Vector3d least(1e9, 1e9, 1e9), most = -least;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t corner : mesh.triangles[t])
      if (mesh.part_of[t] == part) {
        least = least.cwiseMin(mesh.vertices[corner]);
        most = most.cwiseMax(mesh.vertices[corner]);
      }
  return (least + most) / 2;
}

std::size_t count_near(const ColouredMesh& mesh, const Vector3d& colour) {
  std::size_t count = 0;
  for (std::uint32_t part = 0; part < mesh.parts.size(); ++part)
    count += (colour_of(mesh, part) - colour).norm() < 1e-4;
  return count;
}

}  // namespace

TEST_CASE("six faces of a box have their names and, as displayed, their colours") {
  const TemporaryFolder folder;
  for (const StepSchema schema : {StepSchema::ap214, StepSchema::ap242}) {
    write_step_box(folder / "box.step", schema);
    const ColouredMesh mesh = mesh_of(folder / "box.step");
    REQUIRE(mesh.parts.size() == 6);
    CHECK(mesh.missing.empty());
    const std::vector<Vector3d> middles = {{0, 10, 15}, {10, 10, 15}, {5, 0, 15},
                                           {5, 20, 15}, {5, 10, 0},   {5, 10, 30}};
    for (std::uint32_t k = 0; k < 6; ++k) {
      INFO(k);
      CHECK(mesh.parts[k].name == box_faces()[k].name);
      CHECK(mesh.parts[k].material == "box");
      CHECK((colour_of(mesh, k) - box_faces()[k].colour).norm() < 1e-4);
      CHECK((middle_of(mesh, k) - middles[k]).norm() < 1e-9);
    }
  }
}

// The standard (ISO 10303-46, colour_rgb) says parts of full intensity; programs write what they
// show: the text of the file is changed here, and no writer takes part.
TEST_CASE("the numbers of COLOUR_RGB are colours as displayed") {
  const TemporaryFolder folder;
  write_step_box(folder / "box.step", StepSchema::ap214);
  std::string text = read_file(folder / "box.step");
  const std::size_t at = text.find("COLOUR_RGB('',0.5"), end = text.find(");", at);
  REQUIRE(at != std::string::npos);
  text.replace(at, end - at, "COLOUR_RGB('',0.5,0.25,0.75");
  const ColouredMesh mesh = mesh_of(folder.write("changed.step", text));
  CHECK(count_near(mesh, {.5, .25, .75}) == 1);
}

TEST_CASE("a face's colour wins over its body's, and that over the product's") {
  const TemporaryFolder folder;
  write_step_bodies(folder / "bodies.step");
  const ColouredMesh mesh = mesh_of(folder / "bodies.step");
  REQUIRE(mesh.parts.size() == 12);
  CHECK(count_near(mesh, {1, 1, 0}) == 1);
  CHECK(count_near(mesh, {1, 0, 0}) == 5);
  CHECK(count_near(mesh, {0, 0, 1}) == 6);
  CHECK(mesh.parts[1].name == "left.face 2");
  CHECK(mesh.parts[6].name == "right.face 1");
}

TEST_CASE("instances stand where they are placed, in the colour of each") {
  const TemporaryFolder folder;
  write_step_assembly(folder / "outer.step");
  const ColouredMesh mesh = mesh_of(folder / "outer.step");
  REQUIRE(mesh.parts.size() == 12);
  CHECK(count_near(mesh, {0, 1, 0}) == 5);
  CHECK(count_near(mesh, {1, 0, 0}) == 5);
  CHECK(count_near(mesh, {1, 1, 1}) == 2);
  // The white face is x = 0: y = 0 once turned, and where it was when moved alone.
  CHECK((middle_of(mesh, 0) - Vector3d(98, 0, 3)).norm() < 1e-9);
  CHECK((middle_of(mesh, 6) - Vector3d(0, 52, 3)).norm() < 1e-9);
  CHECK(mesh.parts[0].name == "peg.face 1");
}

TEST_CASE("without colours a file is refused, and a table of names gives it some") {
  const TemporaryFolder folder;
  write_plain_step(folder / "plain.step");
  const Result<Scene> refused = read_scene(folder / "plain.step");
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.error().find("plain.step: holds no colours: face 'block.face 1' of 'block' has "
                             "none; colour every face in the CAD program") != std::string::npos);
  CHECK(refused.error().find("[mesh] colours") != std::string::npos);
  CHECK(refused.error().find('\n') == std::string::npos);
  SceneReading reading;
  reading.colours.by_name = {{"block", {1, 0, 0}}, {"block.face 6", {0, 1, 0}}};
  const Result<Scene> scene = read_scene(folder / "plain.step", reading);
  if (!scene) FAIL(scene.error());
  REQUIRE(scene.value().surfaces.size() == 2);
  CHECK(scene.value().names == std::vector<std::string>{"block.face 1 and 4 more", "block.face 6"});
  reading.colours.by_name.erase("block");
  CHECK_FALSE(read_scene(folder / "plain.step", reading).ok());
  reading.colours.missing = Vector3d(0, 0, 1);
  CHECK(read_scene(folder / "plain.step", reading).ok());
}

TEST_CASE("where some faces are coloured those without are named") {
  const TemporaryFolder folder;
  write_plain_step(folder / "some.step", 2);
  const ColouredMesh mesh = mesh_of(folder / "some.step");
  REQUIRE(mesh.missing.size() == 4);
  CHECK(mesh.missing.front().what == "lacks a colour: face 'block.face 3' of 'block' has none");
}

}  // namespace aspect
