// 3MF archives with known colours and places.
#include <catch2/catch.hpp>
#include <random>

#include "compiler/scene/mesh_reader.h"
#include "compiler/scene/scene_reader.h"
#include "tests/compiler/scene/threemf_samples.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

ColouredMesh mesh_of(const std::vector<ZipMember>& members) {
  const TemporaryFolder folder;
  Result<ColouredMesh> mesh = read_coloured_mesh(folder.write("a.3MF", zip_of(members)));
  if (!mesh) FAIL(mesh.error());
  return std::move(mesh).value();
}

std::string error_of(const std::vector<ZipMember>& members) {
  const Result<Scene> scene = parse_mesh(zip_of(members), "a.3mf");
  if (scene.ok()) return "no error";
  CHECK(scene.error().find('\n') == std::string::npos);
  CHECK(scene.error().find("a.3mf: ") == 0);
  return scene.error();
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

Vector3d bytes(int red, int green, int blue) {
  return Vector3d(red, green, blue) / 255;
}

}  // namespace

TEST_CASE("colours of an object, of a triangle and of its corners are those that 3MF shows") {
  const ColouredMesh mesh =
      mesh_of(threemf_of(kThreeMfColours +
                         tetrahedron(5, "pid=\"1\" pindex=\"0\" name=\"lid\"",
                                     {"", "pid=\"1\" p1=\"1\"", "pid=\"2\" p1=\"0\"",
                                      "pid=\"2\" p1=\"0\" p2=\"1\" p3=\"2\""}) +
                         "</resources><build><item objectid=\"5\"/></build>"));
  REQUIRE(mesh.triangles.size() == 4);
  CHECK(mesh.missing.empty());
  CHECK((mesh.colours[0] - bytes(0x11, 0x80, 0xff)).norm() < 1e-9);
  CHECK((mesh.colours[1] - bytes(0x20, 0x30, 0x40)).norm() < 1e-9);
  CHECK((mesh.colours[2] - bytes(255, 0, 0)).norm() < 1e-9);
  CHECK((mesh.colours[3] - bytes(85, 85, 85)).norm() < 1e-9);  // of red, green and blue
  CHECK(mesh.parts[mesh.part_of[0]].name == "lid");
  CHECK(mesh.parts[mesh.part_of[0]].material == "sky");
  CHECK(mesh.parts[mesh.part_of[1]].material == "slate");
}

TEST_CASE("components, items and model parts are placed, and lengths are millimetres") {
  const std::string placed =
      kThreeMfColours + tetrahedron(5, "pid=\"2\" pindex=\"0\"", {"", "", "", ""}) +
      "<object id=\"6\"><components><component objectid=\"5\" transform=\"0 1 0 -1 0 0 0 0 1 10 0 "
      "0\"/><component objectid=\"3\" p:path=\"/3D/other.model\"/></components></object>"
      "</resources><build><item objectid=\"6\" transform=\"1 0 0 0 1 0 0 0 1 0 0 5\"/></build>";
  std::vector<ZipMember> members = threemf_of(placed, "unit=\"inch\"");
  members.push_back(
      {"3D/other.model",
       model_text(kThreeMfColours + tetrahedron(3, "pid=\"2\" pindex=\"1\"", {"", "", "", ""}) +
                  "</resources><build/>")});
  const ColouredMesh mesh = mesh_of(members);
  REQUIRE(mesh.triangles.size() == 8);
  // Corners 0 0 0, 1 0 0, 0 2 0, 0 0 3: turned, x goes to y and y to -x.
  const std::vector<Vector3d> expected = {{10, 0, 5}, {10, 1, 5}, {8, 0, 5}, {10, 0, 8},
                                          {0, 0, 5},  {1, 0, 5},  {0, 2, 5}, {0, 0, 8}};
  for (std::size_t k = 0; k < expected.size(); ++k)
    CHECK((mesh.vertices[k] - 25.4 * expected[k]).norm() < 1e-9);
  CHECK((mesh.colours.front() - bytes(255, 0, 0)).norm() < 1e-9);
  CHECK((mesh.colours.back() - bytes(0, 255, 0)).norm() < 1e-9);
}

TEST_CASE("a mirrored 3MF object stays turned outwards") {
  const ColouredMesh mesh = mesh_of(threemf_of(
      kThreeMfColours + tetrahedron(5, "pid=\"2\" pindex=\"0\"", {"", "", "", ""}) +
      "</resources><build><item objectid=\"5\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/></build>"));
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    volume += mesh.vertices[a].cross(mesh.vertices[b]).dot(mesh.vertices[c]) / 6;
  CHECK(volume == Approx(1));
}

TEST_CASE("colours that a 3MF lacks are told in one line, and can be given by name") {
  const std::vector<ZipMember> plain =
      threemf_of("<resources>" + tetrahedron(5, "name=\"lid\"", {"", "", "", ""}) +
                 "</resources><build><item objectid=\"5\"/></build>");
  CHECK(holds(error_of(plain), "'lid' has faces without a colour; colour them"));
  CHECK(holds(
      error_of(threemf_of(kThreeMfColours + tetrahedron(5, "", {"pid=\"9\" p1=\"0\"", "", "", ""}) +
                          "</resources><build><item objectid=\"5\"/></build>")),
      "of group 9, which is not there"));
  CHECK(holds(error_of(threemf_of(kThreeMfColours +
                                  tetrahedron(5, "pid=\"2\" pindex=\"7\"", {"", "", "", ""}) +
                                  "</resources><build><item objectid=\"5\"/></build>")),
              "of place 7 of group 2"));
  MeshColours colours;
  colours.by_name = {{"lid", {1, 0, 0}}};
  CHECK(parse_mesh(zip_of(plain), "a.3mf", colours).ok());
}

TEST_CASE("what is wrong with a 3MF is told in one line") {
  CHECK(holds(error_of({{"a.txt", "nothing"}}), "holds no part 3D/3dmodel.model"));
  CHECK(holds(error_of(threemf_of("<resources></resources><build/>")), "builds nothing"));
  CHECK(holds(error_of(threemf_of("<resources></resources><build><item objectid=\"7\"/></build>")),
              "places object 7"));
  CHECK(holds(error_of(threemf_of("<resources><m:colorgroup id=\"1\"><m:color color=\"red\"/>")),
              "3D/3dmodel.model line 1: 'red' is no colour"));
  CHECK(holds(error_of(threemf_of("<resources>", "unit=\"ell\"")), "unit \"ell\" is unknown"));
  CHECK(holds(error_of({{"3D/3dmodel.model", "<!DOCTYPE a [<!ENTITY b \"c\">]><a>&b;</a>"}}),
              "DOCTYPE"));
  CHECK(holds(error_of(threemf_of("<resources><object id=\"1\"><components><component "
                                  "objectid=\"1\"/></components></object></resources><build><item "
                                  "objectid=\"1\"/></build>")),
              "nested more than 32 deep"));
}

TEST_CASE("3MF archives cut off or changed anywhere are read or refused in one line") {
  const std::string whole = zip_of(
      threemf_of(kThreeMfColours + tetrahedron(5, "pid=\"1\" pindex=\"0\"", {"", "", "", ""}) +
                 "</resources><build><item objectid=\"5\"/></build>"));
  std::mt19937 random(7);
  for (std::size_t round = 0; round < 600; ++round) {
    std::string text = whole;
    if (round < 200)
      text.resize(text.size() * round / 200);
    else
      for (std::size_t k = 0; k <= round % 6; ++k)
        text[random() % text.size()] = static_cast<char>(random() % 256);
    const Result<Scene> scene = parse_mesh(text, "a.3mf");
    if (!scene.ok()) REQUIRE(scene.error().find('\n') == std::string::npos);
  }
}

}  // namespace aspect
