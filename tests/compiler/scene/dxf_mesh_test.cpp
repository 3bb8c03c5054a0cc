#include "compiler/scene/dxf_mesh.h"

#include <dxflib/dl_codes.h>
#include <fmt/format.h>

#include <Eigen/Geometry>

#include <catch2/catch.hpp>

#include "compiler/scene/aci_palette.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

std::string file_of(const std::string& entities, const std::string& blocks = {}) {
  return "0\nSECTION\n2\nTABLES\n0\nLAYER\n2\nWALL\n62\n3\n0\nLAYER\n2\nROOF\n62\n1\n420\n"
         "8421504\n0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n" +
         blocks + "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}

// With corners (0,0,0), (1,0,0), (1,2,0).
std::string face(const std::string& groups) {
  return "0\n3DFACE\n" + groups +
         "10\n0\n20\n0\n30\n0\n11\n1\n21\n0\n31\n0\n12\n1\n22\n2\n32\n0\n13\n1\n23\n2\n33\n0\n";
}

std::string block_of(const std::string& name, const std::string& entities) {
  return "0\nBLOCK\n8\n0\n2\n" + name + "\n10\n1\n20\n0\n30\n0\n" + entities + "0\nENDBLK\n";
}

ColouredMesh only(const std::string& file, std::size_t triangles) {
  ColouredMesh mesh = parse_dxf(file);
  REQUIRE(mesh.triangles.size() == triangles);
  return mesh;
}

void require_corner(const ColouredMesh& mesh, std::size_t triangle, std::size_t corner,
                    const Vector3d& expected) {
  const Vector3d& found = mesh.vertices[mesh.triangles[triangle][corner]];
  INFO(found.transpose() << " for " << expected.transpose());
  CHECK((found - expected).norm() < 1e-12);
}

}  // namespace

TEST_CASE("the palette of 255 colours is dxflib's but for its rounding") {
  for (int number = 1; number <= 249; ++number) {
    const double* other = dxfColors[number];
    const Vector3d difference = aci_colour(number) - Vector3d(other[0], other[1], other[2]);
    INFO(number << ": " << aci_colour(number).transpose() << " and " << other[0] << " " << other[1]
                << " " << other[2]);
    CHECK(difference.cwiseAbs().maxCoeff() <= .03);
  }
  CHECK(aci_colour(255) == Vector3d(1, 1, 1));
  CHECK(aci_colour(0).isZero());
}

TEST_CASE("an entity's colour is its own true colour, its number or its layer's") {
  const auto colour = [](const std::string& groups) {
    return only(file_of(face(groups)), 1).colours[0];
  };
  CHECK(colour("8\nWALL\n") == Vector3d(0, 1, 0));
  CHECK(colour("8\nWALL\n62\n256\n") == Vector3d(0, 1, 0));
  CHECK(colour("8\nWALL\n62\n5\n") == Vector3d(0, 0, 1));
  CHECK(colour("8\nWALL\n62\n5\n420\n16744448\n").isApprox(Vector3d(1, 128 / 255., 0)));
  CHECK(colour("8\nROOF\n").isApprox(Vector3d::Constant(128 / 255.)));
  CHECK(colour("8\nunknown\n") == Vector3d(1, 1, 1));
}

TEST_CASE("an inserted block is scaled, turned and moved about its base point") {
  const std::string blocks = block_of("PART", face("8\n0\n62\n0\n"));
  const ColouredMesh mesh = only(
      file_of("0\nINSERT\n8\nWALL\n2\nPART\n10\n10\n20\n20\n30\n30\n41\n2\n42\n3\n43\n1\n50\n90\n",
              blocks),
      1);
  require_corner(mesh, 0, 0, {10, 18, 30});  // (-1, 0, 0) scaled to (-2, 0, 0)
  require_corner(mesh, 0, 1, {10, 20, 30});
  require_corner(mesh, 0, 2, {4, 20, 30});      // (0, 2, 0) scaled to (0, 6, 0)
  CHECK(mesh.colours[0] == Vector3d(0, 1, 0));  // by block, whose layer is green
  CHECK(mesh.parts[mesh.part_of[0]].name == "WALL");
}

TEST_CASE("blocks nest, repeat in rows and columns, and stand on their extrusion") {
  const std::string blocks =
      block_of("IN", face("8\n0\n62\n0\n")) +
      block_of("OUT", "0\nINSERT\n8\n0\n62\n0\n2\nIN\n10\n1\n20\n0\n30\n0\n");
  const ColouredMesh rows =
      only(file_of("0\nINSERT\n8\n0\n62\n6\n2\nOUT\n70\n2\n71\n3\n44\n10\n45\n20\n", blocks), 6);
  require_corner(rows, 5, 0, {9 - 0.0, 40, 0});  // the last column and row, less OUT's base
  CHECK(rows.colours[5] == Vector3d(1, 0, 1));
  const ColouredMesh turned =
      only(file_of("0\nINSERT\n8\n0\n2\nIN\n210\n0\n220\n0\n230\n-1\n", blocks), 1);
  require_corner(turned, 0, 2, {0, 2, 0});
  require_corner(turned, 0, 0, {1, 0, 0});  // x is mirrored where z points down
}

TEST_CASE("a mesh of M x N points has its cells, and closes where it says so") {
  std::string points;
  for (int k = 0; k < 12; ++k)
    points += fmt::format("0\nVERTEX\n8\n0\n70\n64\n10\n{}\n20\n{}\n30\n{}\n", k % 4, k / 4,
                          k % 3 + k * k % 5);
  const auto cells = [&](int flags) {
    return parse_dxf(file_of(fmt::format("0\nPOLYLINE\n8\n0\n70\n{}\n71\n3\n72\n4\n", flags) +
                             points + "0\nSEQEND\n"))
               .triangles.size() /
           2;
  };
  CHECK(cells(16) == 6);
  CHECK(cells(17) == 9);
  CHECK(cells(48) == 8);
  CHECK(cells(49) == 12);
}

TEST_CASE("a solid's corners are in its crossed order") {
  const ColouredMesh mesh =
      only(file_of("0\nSOLID\n8\n0\n10\n0\n20\n0\n11\n1\n21\n0\n12\n0\n22\n1\n13\n1\n23\n1\n"), 2);
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    area += (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
  CHECK(area == Approx(2));
}

TEST_CASE("what only a modeller understands is a warning, and bad files an error with the line") {
  const ColouredMesh mesh = parse_dxf(file_of(face("8\n0\n") + "0\n3DSOLID\n8\n0\n1\nabc\n"));
  REQUIRE(mesh.warnings.size() == 1);
  CHECK(mesh.warnings[0] ==
        "left out: 1 3DSOLID; export what of it should be seen as a mesh or as 3DFACEs");

  const auto error = [](const std::string& file) {
    try {
      parse_dxf(file);
    } catch (const MeshError& failure) {
      return fmt::format("{}: {}", failure.line(), failure.what());
    }
    return std::string("no error");
  };
  CHECK(error("AutoCAD Binary DXF\r\n").find("binary DXF is not read") != std::string::npos);
  CHECK(error("0\nSECTION\nx\n") == "3: 'x' where a group code should be; is it a DXF file?");
  CHECK(error("0\nSECTION\n").find("ends without EOF") != std::string::npos);
  CHECK(error(file_of(face("62\nred\n"))).find("group 62 of 3DFACE is 'red'") != std::string::npos);
  const std::string endless = block_of("A", "0\nINSERT\n2\nA\n8\n0\n");
  CHECK(error(file_of("0\nINSERT\n2\nA\n8\n0\n", endless)).find("past 16 levels") !=
        std::string::npos);
  CHECK(error(file_of("0\nPOLYLINE\n70\n64\n0\nVERTEX\n70\n128\n71\n1\n72\n2\n73\n3\n"))
            .find("a face has vertex 1, but there are 0") != std::string::npos);
}

}  // namespace aspect
