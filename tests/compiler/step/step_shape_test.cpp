// Triangles against the exact surfaces, and units.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "compiler/scene/mesh_reader.h"
#include "tests/compiler/step/step_samples.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

// The largest distance of points within the triangles from the ball and the rod of
// write_curved_step().
double worst_error(const ColouredMesh& mesh) {
  double worst = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    for (int i = 0; i <= 8; ++i)
      for (int j = 0; j <= 8 - i; ++j) {
        const Vector3d p =
            (i * mesh.vertices[a] + j * mesh.vertices[b] + (8 - i - j) * mesh.vertices[c]) / 8;
        const double rod = std::hypot(p.x(), p.y()) - 5;
        const double off = mesh.parts[mesh.part_of[t]].material == "ball" ? p.norm() - 10
                           : p.z() < 20 + 1e-9 || p.z() > 40 - 1e-9       ? std::max(rod, 0.)
                                                                          : rod;
        worst = std::max(worst, std::abs(off));
      }
  }
  return worst;
}

double volume_of(const ColouredMesh& mesh) {
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    volume += mesh.vertices[a].cross(mesh.vertices[b]).dot(mesh.vertices[c]) / 6;
  return volume;
}

}  // namespace

TEST_CASE("triangles of curved faces are as near to them as was asked") {
  const TemporaryFolder folder;
  write_curved_step(folder / "curved.step");
  const double diagonal = std::hypot(20., 20., 50.);
  std::size_t before = 0;
  for (const double share : {.003, .001, .0002}) {
    const Result<ColouredMesh> mesh =
        read_coloured_mesh(folder / "curved.step", kUncoloured, share);
    if (!mesh) FAIL(mesh.error());
    INFO(share);
    CHECK(worst_error(mesh.value()) < share * diagonal);
    CHECK(worst_error(mesh.value()) > 0);
    CHECK(mesh.value().triangles.size() > before);
    before = mesh.value().triangles.size();
    // Turned outwards; the polyhedron is inside.
    const double exact = 4. / 3 * M_PI * 1000 + M_PI * 25 * 20;
    CHECK(volume_of(mesh.value()) == Approx(exact).epsilon(.03));
    CHECK(volume_of(mesh.value()) < exact);
  }
}

TEST_CASE("whatever the file's unit, lengths are millimetres") {
  const TemporaryFolder folder;
  // The writer leaves numbers as they are: the box measures 10 x 20 x 30 of the unit.
  for (const auto& [unit, millimetres] :
       {std::pair<const char*, double>{"MM", 1}, {"INCH", 25.4}}) {
    write_step_box(folder / "box.step", StepSchema::ap214, unit);
    const Result<Scene> scene = read_mesh(folder / "box.step");
    if (!scene) FAIL(scene.error());
    const SourceFromObject& source = scene.value().source_from_object;
    CHECK((source.translation / millimetres - Vector3d(5, 10, 15)).norm() < 1e-6);
    double radius = 0;
    for (const Primitive& primitive : scene.value().primitives)
      for (const Vector3d& vertex : std::get<Polygon>(primitive.shape).vertices)
        radius = std::max(radius, vertex.norm());
    CHECK(source.scale * radius == Approx(millimetres * std::hypot(5., 10., 15.)));
  }
}

TEST_CASE("a file that counts metres is a thousand times as large as one of the same numbers") {
  const TemporaryFolder folder;
  write_step_box(folder / "box.step", StepSchema::ap214);
  std::string text = read_file(folder / "box.step");
  const std::string unit = "SI_UNIT(.MILLI.,.METRE.)";
  REQUIRE(text.find(unit) != std::string::npos);
  text.replace(text.find(unit), unit.size(), "SI_UNIT($,.METRE.)");
  const Result<Scene> scene = read_mesh(folder.write("metres.step", text));
  if (!scene) FAIL(scene.error());
  CHECK((scene.value().source_from_object.translation - Vector3d(5e3, 1e4, 15e3)).norm() < 1e-3);
}

TEST_CASE("a closed body stays closed: faces meet in the same vertices") {
  const TemporaryFolder folder;
  write_many_faced_step(folder / "plate.step", 9);
  const Result<ColouredMesh> read = read_coloured_mesh(folder / "plate.step");
  if (!read) FAIL(read.error());
  const ColouredMesh& mesh = read.value();
  using Place = std::array<double, 3>;
  std::map<std::pair<Place, Place>, int> edges;
  const auto place = [&](std::uint32_t k) -> Place {
    return {mesh.vertices[k].x(), mesh.vertices[k].y(), mesh.vertices[k].z()};
  };
  for (const auto& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Place a = place(triangle[k]), b = place(triangle[(k + 1) % 3]);
      if (a != b) ++edges[{a, b}];
    }
  std::size_t open = 0;
  for (const auto& [edge, count] : edges) open += !edges.contains({edge.second, edge.first});
  CHECK(open == 0);
}

}  // namespace aspect
