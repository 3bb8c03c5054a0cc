// What of a DXF drawing is the object: what a viewer shows in model space, and with its thickness.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numbers>
#include <set>

#include "compiler/scene/dxf_mesh.h"
#include "compiler/scene/dxf_names.h"
#include "compiler/scene/mesh_reader.h"

namespace aspect {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

std::string layer(const std::string& name, int flags, int colour) {
  return fmt::format("0\nLAYER\n2\n{}\n70\n{}\n62\n{}\n", name, flags, colour);
}

std::string file_of(const std::string& entities, const std::string& blocks = {}) {
  return "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n" + layer("0", 0, 7) + layer("L1", 0, 1) +
         layer("OFF", 0, -3) + layer("ICE", 1, 5) + layer("ICE IN NEW VIEWPORTS", 2, 5) +
         "0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n" + blocks +
         "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}

// Of half a unit of area.
std::string face(const std::string& groups, double size = 1) {
  return fmt::format(
      "0\n3DFACE\n{0}10\n0\n20\n0\n30\n0\n11\n{1}\n21\n0\n31\n0\n12\n{1}\n22\n{1}\n32\n0\n13\n"
      "{1}\n23\n{1}\n33\n0\n",
      groups, size);
}

std::string block_of(const std::string& name, const std::string& entities) {
  return "0\nBLOCK\n8\n0\n2\n" + name + "\n10\n0\n20\n0\n30\n0\n" + entities + "0\nENDBLK\n8\n0\n";
}

std::string insert_of(const std::string& block, const std::string& groups) {
  return "0\nINSERT\n" + groups + "2\n" + block + "\n10\n0\n20\n0\n30\n0\n";
}

double area_of(const ColouredMesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    area += (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
  return area / 2;
}

Eigen::AlignedBox3d box_of(const ColouredMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) box.extend(mesh.vertices[corner]);
  return box;
}

void require_box(const ColouredMesh& mesh, const Vector3d& least, const Vector3d& greatest) {
  const Eigen::AlignedBox3d box = box_of(mesh);
  INFO(box.min().transpose() << " to " << box.max().transpose());
  CHECK((box.min() - least).norm() < 1e-9);
  CHECK((box.max() - greatest).norm() < 1e-9);
}

// Every edge between two triangles that show the same side, as that of a closed body.
bool is_closed(const ColouredMesh& mesh) {
  using Edge = std::array<double, 6>;
  const auto edge = [](const Vector3d& a, const Vector3d& b) {
    return Edge{a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
  };
  std::multiset<Edge> ways, ways_back;
  for (const auto& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d& a = mesh.vertices[triangle[k]];
      const Vector3d& b = mesh.vertices[triangle[(k + 1) % 3]];
      ways.insert(edge(a, b));
      ways_back.insert(edge(b, a));
    }
  return ways == ways_back;
}

std::string thick(const std::string& kind, const std::string& groups, double thickness = 3) {
  return fmt::format("0\n{}\n8\n0\n39\n{}\n{}", kind, thickness, groups);
}

ColouredMesh mesh_of(const std::string& entities) {
  ColouredMesh mesh = parse_dxf(file_of(entities));
  CHECK(mesh.warnings.empty());
  return mesh;
}

const std::string kTail = "; export what of it should be seen as a mesh or as 3DFACEs";

}  // namespace

TEST_CASE("what a DXF drawing does not show is no part of the object, and is counted") {
  const ColouredMesh mesh = parse_dxf(file_of(
      face("8\nL1\n", 2) + face("8\nOFF\n", 400) + face("8\nice\n", 400) +
      face("8\nL1\n60\n1\n", 400) + face("8\nL1\n67\n1\n", 400) + face("8\nL1\n67\n1\n", 300) +
      face("8\nL1\n60\n0\n67\n0\n", 1) + face("8\nICE IN NEW VIEWPORTS\n", 1)));
  CHECK(mesh.triangles.size() == 3);
  require_box(mesh, {0, 0, 0}, {2, 2, 0});
  REQUIRE(mesh.warnings.size() == 1);
  CHECK(mesh.warnings[0] ==
        "not to be seen in the drawing, and left out: 1 on layers that are off, 1 on frozen layers "
        "(ICE, OFF), 1 invisible, 2 in paper space");
}

TEST_CASE("a hidden polyline takes its vertices along") {
  const std::string vertices =
      "0\nVERTEX\n8\n0\n10\n0\n20\n0\n0\nVERTEX\n8\n0\n10\n1\n20\n0\n0\nSEQEND\n8\n0\n";
  const ColouredMesh mesh =
      parse_dxf(file_of("0\nPOLYLINE\n8\nOFF\n66\n1\n39\n3\n" + vertices + face("8\n0\n")));
  CHECK(mesh.triangles.size() == 1);
  REQUIRE(mesh.warnings.size() == 1);
  CHECK(mesh.warnings[0].find("1 on layers that are off (OFF)") != std::string::npos);
}

TEST_CASE("a frozen layer hides all of a block that is inserted on it, one that is off its own") {
  const std::string blocks =
      block_of("part", face("8\n0\n", 1) + face("8\nL1\n", 2) + face("8\nOFF\n", 3));
  const auto box = [&](const std::string& groups) {
    return box_of(parse_dxf(file_of(insert_of("PART", groups) + face("8\n0\n", .5), blocks)))
        .sizes()
        .x();
  };
  CHECK(box("8\n0\n") == 2);
  CHECK(box("8\nICE\n") == .5);
  CHECK(box("8\nL1\n60\n1\n") == .5);
  CHECK(box("8\nL1\n67\n1\n") == .5);
  const ColouredMesh off =
      parse_dxf(file_of(insert_of("PART", "8\nOFF\n"), blocks));  // what is on L1 is seen
  REQUIRE(off.triangles.size() == 1);
  CHECK(off.colours[0] == Vector3d(1, 0, 0));
  CHECK(off.warnings.at(0).find("2 on layers that are off (OFF)") != std::string::npos);
}

TEST_CASE("names of layers and blocks are equal whatever their case") {
  const ColouredMesh mesh = parse_dxf(file_of(
      face("8\nl1\n") + face("8\nL1\n") + insert_of("Teil \xC3\x84", "8\nl1\n") + face("8\nL2\n"),
      block_of("TEIL \xC3\xA4", face("8\n0\n"))));
  REQUIRE(mesh.triangles.size() == 4);
  for (std::size_t t = 0; t < 3; ++t) {
    CHECK(mesh.colours[t] == Vector3d(1, 0, 0));
    CHECK(mesh.parts[mesh.part_of[t]].name == "L1");
  }
  CHECK(mesh.colours[3] == Vector3d(1, 1, 1));
  CHECK(mesh.parts.size() == 2);
  CHECK(dxf_key("\xCE\xA9\xD0\x96\xD0\x81") == "\xCF\x89\xD0\xB6\xD1\x91");  // Greek, Cyrillic
  CHECK(dxf_key("\xC3\x97\xC3") == "\xC3\x97\xC3");  // no letter, and half of one
}

TEST_CASE("kinds that are not read are counted in one line") {
  const std::string line = "0\nLINE\n8\n0\n10\n0\n20\n0\n11\n1\n21\n0\n";
  const std::string wide = "0\nLWPOLYLINE\n8\n0\n43\n.5\n39\n3\n10\n0\n20\n0\n10\n5\n20\n0\n";
  const ColouredMesh mesh =
      parse_dxf(file_of(face("8\n0\n") + line + line + "0\nTEXT\n8\n0\n39\n2\n1\nabc\n" + wide +
                            insert_of("nowhere", "8\n0\n") + insert_of("WALLS", "8\n0\n") +
                            "0\n3DSOLID\n8\n0\n0\nCIRCLE\n8\n0\n40\n2\n",
                        "0\nBLOCK\n8\n0\n2\nwalls\n70\n4\n1\nwalls.dwg\n0\nENDBLK\n8\n0\n"));
  REQUIRE(mesh.warnings.size() == 1);
  CHECK(mesh.warnings[0] ==
        "left out: 1 3DSOLID, 1 CIRCLE, 1 INSERT of another file, 1 INSERT without its "
        "block, 2 LINE, "
        "1 LWPOLYLINE with a width, 1 TEXT" +
            kTail);
}

TEST_CASE("a drawing of which nothing is left says why") {
  const Result<Scene> scene = parse_mesh(
      file_of("0\nLINE\n8\n0\n10\n0\n20\n0\n11\n1\n21\n0\n" + face("8\nICE\n")), "a.dxf");
  REQUIRE_FALSE(scene.ok());
  CHECK(scene.error() == "a.dxf: holds no faces; left out: 1 LINE" + kTail +
                             "; not to be seen in the drawing, and left out: 1 on frozen layers "
                             "(ICE)");
}

TEST_CASE("a line's thickness is a wall along its extrusion") {
  const std::string line = "10\n1\n20\n2\n30\n3\n11\n5\n21\n2\n31\n3\n";
  const ColouredMesh upright = mesh_of(thick("LINE", line));
  require_box(upright, {1, 2, 3}, {5, 2, 6});
  CHECK(area_of(upright) == Approx(12));
  // Its ends are the world's whatever its extrusion, and it may go down.
  require_box(mesh_of(thick("LINE", line + "210\n0\n220\n1\n230\n0\n", -3)), {1, -1, 3}, {5, 2, 3});
}

TEST_CASE("a circle's thickness is a closed cylinder, an arc's an open wall") {
  const std::string groups = "10\n1\n20\n2\n30\n-1\n40\n2\n";
  const ColouredMesh cylinder = mesh_of(thick("CIRCLE", groups));
  require_box(cylinder, {-1, 0, -1}, {3, 4, 2});
  CHECK(area_of(cylinder) == Approx(2 * pi * 4 + 2 * pi * 2 * 3).epsilon(.002));
  CHECK(is_closed(cylinder));
  const ColouredMesh arc = mesh_of(thick("ARC", groups + "50\n270\n51\n90\n"));
  require_box(arc, {1, 0, -1}, {3, 4, 2});
  CHECK(area_of(arc) == Approx(pi * 2 * 3).epsilon(.002));
  CHECK_FALSE(is_closed(arc));
  // In its own coordinates, whose x is the world's -x here.
  require_box(mesh_of(thick("ARC", groups + "50\n270\n51\n90\n210\n0\n220\n0\n230\n-1\n")),
              {-3, 0, -2}, {-1, 4, 1});
}

TEST_CASE("a solid's and a trace's thickness is a closed body") {
  const std::string square = "10\n0\n20\n0\n11\n2\n21\n0\n12\n0\n22\n2\n13\n2\n23\n2\n";
  for (const char* kind : {"SOLID", "TRACE"}) {
    const ColouredMesh body = mesh_of(thick(kind, square));
    require_box(body, {0, 0, 0}, {2, 2, 3});
    CHECK(area_of(body) == Approx(2 * 4 + 4 * 2 * 3));
    CHECK(is_closed(body));
  }
  // Three corners: the fourth is the third again.
  const ColouredMesh wedge =
      mesh_of(thick("SOLID", "10\n0\n20\n0\n11\n2\n21\n0\n12\n0\n22\n2\n13\n0\n23\n2\n"));
  CHECK(area_of(wedge) == Approx(2 * 2 + 3 * (4 + std::sqrt(8))));
  CHECK(is_closed(wedge));
}

TEST_CASE("a polyline's thickness is a wall along its lines and arcs") {
  // A square of side 2 whose right side is a half circle to the outside.
  const double area = 3 * (3 * 2 + pi);
  const std::string light =
      "90\n4\n70\n1\n38\n7\n10\n0\n20\n0\n10\n2\n20\n0\n42\n1\n10\n2\n20\n2\n10\n0\n20\n2\n";
  const std::string heavy =
      "66\n1\n70\n1\n10\n0\n20\n0\n30\n7\n0\nVERTEX\n8\n0\n10\n0\n20\n0\n0\nVERTEX\n8\n0\n10\n2\n20"
      "\n0\n42\n1\n0\nVERTEX\n8\n0\n10\n2\n20\n2\n0\nVERTEX\n8\n0\n70\n16\n10\n99\n20\n99\n"
      "0\nVERTEX\n8\n0\n10\n0\n20\n2\n0\nSEQEND\n8\n0\n";
  for (const ColouredMesh& mesh :
       {mesh_of(thick("LWPOLYLINE", light)), mesh_of(thick("POLYLINE", heavy))}) {
    require_box(mesh, {0, 0, 7}, {3, 2, 10});
    CHECK(area_of(mesh) == Approx(area).epsilon(.002));
  }
  const std::string open = "70\n0\n10\n0\n20\n0\n10\n2\n20\n0\n42\n-1\n10\n2\n20\n2\n42\n1\n";
  const ColouredMesh inside = mesh_of(thick("LWPOLYLINE", open));  // and no way back
  require_box(inside, {0, 0, 0}, {2, 2, 3});
  CHECK(area_of(inside) == Approx(3 * (2 + pi)).epsilon(.002));
}

TEST_CASE("a part's size is its own, not the title block's beside it") {
  const std::string part = face("8\n0\n", 2);
  const Result<Scene> alone = parse_mesh(file_of(part), "a.dxf");
  const Result<Scene> titled =
      parse_mesh(file_of(part + face("8\n0\n67\n1\n", 400) + face("8\nOFF\n", 400)), "a.dxf");
  REQUIRE(alone.ok());
  REQUIRE(titled.ok());
  CHECK(titled.value().source == alone.value().source);
}

}  // namespace aspect
