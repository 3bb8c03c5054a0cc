#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>

#include "tests/tools/doctor/sick_meshes.h"
#include "tools/doctor/repair.h"
#include "tools/doctor/topology_checks.h"

namespace aspect {
namespace {

using Codes = std::vector<std::string>;

const Eigen::Vector3d kLeast(-1, -2, -3), kMost(4, 3, 2);

std::vector<Finding> findings_of(const ColouredMesh& mesh) {
  return check_topology(face_set_of(mesh)).findings;
}

// The mesh has that disease alone, in that number, and is healthy once it is repaired.
void check_cured(const ColouredMesh& mesh, const std::string& code, std::size_t count) {
  CAPTURE(code);
  const FaceSet set = face_set_of(mesh);
  const Topology topology = check_topology(set);
  CHECK(codes_of(topology.findings) == Codes{code});
  CHECK(finding_of(topology.findings, code).count == count);
  CHECK(finding_of(topology.findings, code).can_fix);
  CHECK(findings_of(repaired_mesh(mesh, set, topology)).empty());
}

void flip(ColouredMesh& mesh, std::size_t triangle) {
  std::swap(mesh.triangles[triangle][1], mesh.triangles[triangle][2]);
}

Scene bob_scene(const std::vector<Polygon>& polygons) {
  Scene scene;
  scene.surfaces.push_back({});
  for (const Polygon& polygon : polygons) scene.primitives.push_back({polygon, 0});
  return scene;
}

std::vector<Polygon> cube_polygons(const Eigen::Vector3d& least, const Eigen::Vector3d& most) {
  const ColouredMesh mesh = cuboid(least, most);
  std::vector<Polygon> polygons;
  for (std::size_t k = 0; k < 12; k += 2) {
    const auto& [a, b, c] = mesh.triangles[k];
    const std::uint32_t d = mesh.triangles[k + 1][2];
    polygons.push_back({{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], mesh.vertices[d]}});
  }
  return polygons;
}

}  // namespace

TEST_CASE("a closed mesh has no fault of topology") {
  CHECK(findings_of(cuboid(kLeast, kMost)).empty());
  CHECK(findings_of(dented_ball(1)).empty());
}

TEST_CASE("the open edges of a closed mesh that lost faces are those that a plain count finds") {
  std::mt19937 random(7);
  for (unsigned trial = 0; trial < 40; ++trial) {
    ColouredMesh mesh = dented_ball(trial);
    const auto lost = static_cast<unsigned>(1 + random() % 60);
    for (unsigned k = 0; k < lost; ++k) erase_triangle(mesh, random() % mesh.triangles.size());
    const std::vector<Finding> findings = findings_of(mesh);
    CAPTURE(trial, lost);
    REQUIRE(codes_of(findings) == Codes{"open_edges"});
    CHECK(finding_of(findings, "open_edges").count == plain_open_edges(mesh));
    CHECK(plain_open_edges(mesh) > 0);
    CHECK_FALSE(finding_of(findings, "open_edges").can_fix);
  }
}

TEST_CASE("exactly the faces that were turned are found flipped, even if they are the most") {
  std::mt19937 random(3);
  for (unsigned trial = 0; trial < 20; ++trial) {
    ColouredMesh mesh = dented_ball(trial);
    std::set<std::size_t> turned;
    const std::size_t count = 1 + random() % 300;
    while (turned.size() < count) turned.insert(random() % mesh.triangles.size());
    for (const std::size_t triangle : turned) flip(mesh, triangle);
    const Topology topology = check_topology(face_set_of(mesh));
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
      REQUIRE(topology.flipped[k] == turned.contains(k));
    check_cured(mesh, "flipped_faces", count);
  }
}

TEST_CASE("faces of a mesh that are turned all over are inside out, but not the wall of a hollow") {
  ColouredMesh mesh = cuboid(kLeast, kMost);
  for (std::size_t k = 0; k < 12; ++k) flip(mesh, k);
  check_cured(mesh, "inside_out", 1);
  for (std::size_t k = 0; k < 12; ++k) flip(mesh, k);
  add_cuboid(mesh, {0, 0, 0}, {1, 1, 1});
  CHECK(findings_of(mesh).empty());
  for (std::size_t k = 12; k < 24; ++k) flip(mesh, k);
  CHECK(findings_of(mesh).empty());
}

TEST_CASE("repeated faces are found, and clash where their colours differ") {
  ColouredMesh mesh = cuboid(kLeast, kMost);
  repeat_triangle(mesh, 3);
  repeat_triangle(mesh, 3);
  repeat_triangle(mesh, 8);
  flip(mesh, 13);
  check_cured(mesh, "duplicate_faces", 3);
  ColouredMesh clash = cuboid(kLeast, kMost);
  repeat_triangle(clash, 3);
  clash.colours.back() = {1, 1, 1};
  check_cured(clash, "clashing_faces", 1);
  CHECK(findings_of(clash).front().severity == Severity::error);
  CHECK(findings_of(clash).front().where == std::vector<std::size_t>{13});
}

TEST_CASE("faces without area are found, and T-junctions that they leave are closed") {
  ColouredMesh mesh = cuboid(kLeast, kMost);
  mesh.triangles.push_back({0, 1, 1});
  mesh.colours.push_back({1, 0, 0});
  mesh.part_of.push_back(0);
  check_cured(mesh, "zero_area_faces", 1);
  // One triangle cut in two at the middle of an edge; a face without area stops the gap.
  ColouredMesh cut = cuboid(kLeast, kMost);
  const auto [a, b, c] = cut.triangles[0];
  const std::uint32_t middle = add_vertex(cut, (cut.vertices[a] + cut.vertices[b]) / 2);
  cut.triangles[0] = {a, middle, c};
  repeat_triangle(cut, 0);
  cut.triangles.back() = {middle, b, c};
  CHECK(findings_of(cut).empty());
  repeat_triangle(cut, 0);
  cut.triangles.back() = {a, b, middle};
  check_cured(cut, "zero_area_faces", 1);
}

TEST_CASE("vertices that are nearly at one place are cracks") {
  ColouredMesh mesh = cuboid(kLeast, kMost);
  const std::uint32_t other =
      add_vertex(mesh, mesh.vertices[mesh.triangles[0][0]] + Eigen::Vector3d(1e-7, 0, 0));
  mesh.triangles[0][0] = other;
  check_cured(mesh, "cracked_vertices", 1);
  mesh.vertices[other].x() += 0.01;
  CHECK(codes_of(findings_of(mesh)) == Codes{"open_edges"});
}

TEST_CASE("a strip that is twisted once has one side") {
  ColouredMesh mesh;
  constexpr std::uint32_t kSides = 12;
  for (std::uint32_t k = 0; k < kSides; ++k) {
    const double angle = 2 * 3.14159265358979 * k / kSides;
    const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0);
    const Eigen::Vector3d way =
        0.3 * (std::cos(angle / 2) * out + std::sin(angle / 2) * Eigen::Vector3d::UnitZ());
    add_vertex(mesh, out - way);
    add_vertex(mesh, out + way);
  }
  for (std::uint32_t k = 0; k < kSides; ++k) {
    const bool last = k + 1 == kSides;
    const std::uint32_t a = 2 * k, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    for (const auto& triangle : {std::array{a, b, c}, std::array{c, b, d}}) {
      mesh.triangles.push_back(triangle);
      mesh.colours.push_back({1, 0, 0});
      mesh.part_of.push_back(0);
    }
  }
  CHECK(codes_of(findings_of(mesh)) == Codes{"one_sided", "open_edges"});
  CHECK(finding_of(findings_of(mesh), "open_edges").count == plain_open_edges(mesh));
}

TEST_CASE("two cuboids that share an edge have one crowded edge") {
  ColouredMesh mesh = cuboid({0, 0, 0}, {1, 1, 1});
  add_cuboid(mesh, {1, 1, 0}, {2, 2, 1});
  CHECK(codes_of(findings_of(mesh)) == Codes{"crowded_edges"});
  CHECK(finding_of(findings_of(mesh), "crowded_edges").count == 1);
}

TEST_CASE("polygons of a scene are closed whatever their winding, and open where one is missing") {
  std::vector<Polygon> polygons = cube_polygons({0, 0, 0}, {1, 2, 3});
  std::reverse(polygons[2].vertices.begin(), polygons[2].vertices.end());
  CHECK(check_topology(face_set_of(bob_scene(polygons))).findings.empty());
  polygons.erase(polygons.begin() + 4);
  const auto findings = check_topology(face_set_of(bob_scene(polygons))).findings;
  REQUIRE(codes_of(findings) == Codes{"open_edges"});
  CHECK(finding_of(findings, "open_edges").count == 4);
}

TEST_CASE("a box that stands open on a face is closed, one beside it is not") {
  std::vector<Polygon> polygons = cube_polygons({0, 0, 0}, {4, 4, 1});
  std::vector<Polygon> peg = cube_polygons({1, 1, 1}, {2, 2, 3});
  peg.erase(peg.begin() + 4);  // its bottom
  polygons.insert(polygons.end(), peg.begin(), peg.end());
  CHECK(check_topology(face_set_of(bob_scene(polygons))).findings.empty());
  for (std::size_t k = 6; k < polygons.size(); ++k)
    for (Eigen::Vector3d& vertex : polygons[k].vertices) vertex.x() += 2.5;
  const auto findings = check_topology(face_set_of(bob_scene(polygons))).findings;
  REQUIRE(codes_of(findings) == Codes{"open_edges"});
  CHECK(finding_of(findings, "open_edges").count == 3);  // the fourth lies on the face all the same
}

TEST_CASE("rims are open unless a ring closes them or they stand on a face") {
  Scene scene = bob_scene(cube_polygons({-2, -2, -1}, {2, 2, 0}));
  scene.primitives.push_back({Cone{{0, 0, 0}, {0, 0, 1}, .5, .5}, 0});
  REQUIRE(check_rims(scene).size() == 1);
  CHECK(check_rims(scene).front().count == 1);
  CHECK(check_rims(scene).front().where == std::vector<std::size_t>{7});
  scene.primitives.push_back({Ring{{0, 0, 1}, {0, 0, 1}, 0, .5}, 0});
  CHECK(check_rims(scene).empty());
  std::get<Cone>(scene.primitives[6].shape).base.x() = 1.8;  // over the edge, and askew
  CHECK(check_rims(scene).front().count == 3);
}

TEST_CASE("points of no size, and soups of a thousand loose triangles, are judged") {
  ColouredMesh point;
  for (int k = 0; k < 3; ++k) add_vertex(point, {5, 5, 5});
  point.triangles = {{0, 1, 2}};
  point.colours = {{1, 0, 0}};
  point.part_of = {0};
  CHECK(codes_of(findings_of(point)) == Codes{"zero_area_faces"});
  std::mt19937 random(5);
  const auto coordinate = [&] { return static_cast<double>(random() % 10000); };
  ColouredMesh soup;
  for (int k = 0; k < 3000; ++k) add_vertex(soup, {coordinate(), coordinate(), coordinate()});
  for (std::uint32_t k = 0; k < 3000; k += 3) {
    soup.triangles.push_back({k, k + 1, k + 2});
    soup.colours.push_back({1, 0, 0});
    soup.part_of.push_back(0);
  }
  CHECK(finding_of(findings_of(soup), "open_edges").count == 3000);
}

}  // namespace aspect
