#include "compiler/scene/mesh_scene.h"

#include <catch2/catch.hpp>
#include <limits>

#include "compiler/scene/picture_fit.h"
#include "tests/compiler/scene/scene_samples.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

const Vector3d kRed(1, 0, 0), kBlue(0, 0, 1);

void add(ColouredMesh& mesh, const std::vector<Vector3d>& corners, const Vector3d& colour) {
  if (mesh.parts.empty()) mesh.parts.push_back({"part", {}});
  std::vector<std::uint32_t> indices;
  for (const Vector3d& corner : corners) indices.push_back(add_vertex(mesh, corner));
  add_face(mesh, indices, colour, 0);
}

ColouredMesh two_squares() {
  ColouredMesh mesh;
  add(mesh, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, kRed);
  add(mesh, {{1, 0, 0}, {2, 0, 0}, {2, 1, 1}, {1, 1, 1}}, kBlue);
  return mesh;
}

Scene scene_from(const ColouredMesh& mesh) {
  Result<Scene> scene = scene_of_mesh(mesh);
  if (!scene) FAIL(scene.error());
  return std::move(scene).value();
}

std::string error_from(const ColouredMesh& mesh) {
  const Result<Scene> scene = scene_of_mesh(mesh);
  return scene.ok() ? "no error" : scene.error();
}

}  // namespace

TEST_CASE("flat pieces become polygons and others meshes, one for each joined colour") {
  ColouredMesh mesh = two_squares();
  add(mesh, {{0, 1, 0}, {1, 1, 0}, {0, 2, 1}}, kRed);  // joined to the first, at an angle
  add(mesh, {{5, 5, 5}, {6, 5, 5}, {5, 6, 5}}, kRed);  // on its own
  const Scene scene = scene_from(mesh);
  REQUIRE(scene.primitives.size() == 3);
  CHECK(shape_of<Mesh>(scene, 0).triangles.size() == 3);
  CHECK(shape_of<Mesh>(scene, 0).vertices.size() == 5);
  CHECK(shape_of<Polygon>(scene, 1).vertices.size() == 4);
  CHECK(shape_of<Polygon>(scene, 2).vertices.size() == 3);
  CHECK(scene.primitives[0].surface == scene.primitives[2].surface);
  CHECK(scene.surfaces.size() == 2);
}

TEST_CASE("flat pieces with a hole, or that overlap themselves, stay meshes") {
  ColouredMesh frame;
  for (const auto& corners : {std::vector<Vector3d>{{0, 0, 0}, {3, 0, 0}, {2, 1, 0}, {1, 1, 0}},
                              {{3, 0, 0}, {3, 3, 0}, {2, 2, 0}, {2, 1, 0}},
                              {{3, 3, 0}, {0, 3, 0}, {1, 2, 0}, {2, 2, 0}},
                              {{0, 3, 0}, {0, 0, 0}, {1, 1, 0}, {1, 2, 0}}})
    add(frame, corners, kRed);
  CHECK(shape_of<Mesh>(scene_from(frame)).triangles.size() == 8);
  ColouredMesh folded;
  add(folded, {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, kRed);
  add(folded, {{2, 0, 0}, {0, 2, 0}, {.5, .5, 0}}, kRed);
  CHECK(shape_of<Mesh>(scene_from(folded)).triangles.size() == 2);
}

TEST_CASE("a model in any place and unit fits with a margin, and the way back is kept") {
  for (const double unit : {1e-6, 1.0, 25.4e3}) {
    ColouredMesh mesh = two_squares();
    for (Vector3d& vertex : mesh.vertices) vertex = unit * (vertex + Vector3d(100, -50, 7));
    const Scene scene = scene_from(mesh);
    CHECK(bounding_radius(scene) == Approx(.9 * fitting_radius(scene.studio)));
    const SourceFromObject& source = scene.source_from_object;
    double nearest = 1;
    for (const Vector3d& vertex : shape_of<Polygon>(scene, 1).vertices) {
      const Vector3d back = (source.scale * vertex + source.translation) / unit;
      nearest = std::min(nearest, (back - Vector3d(102, -49, 8)).norm());
    }
    CHECK(nearest < 1e-9);
    CHECK(scene.studio.ambient == Vector3d(1, 1, 1));
  }
}

TEST_CASE("colours two steps of 255 apart are one surface, and no more") {
  ColouredMesh mesh = two_squares();
  add(mesh, {{0, 0, 5}, {1, 0, 5}, {1, 1, 5}}, Vector3d(253.1 / 255, 0, 0));
  add(mesh, {{0, 0, 6}, {1, 0, 6}, {1, 1, 6}}, Vector3d(252 / 255., 0, 0));
  const Scene scene = scene_from(mesh);
  REQUIRE(scene.surfaces.size() == 3);
  CHECK(scene.primitives[2].surface == 0);
  CHECK(scene.primitives[3].surface == 2);
}

TEST_CASE("the source tells every change of geometry and colour") {
  const std::string before = scene_from(two_squares()).source;
  CHECK(before == scene_from(two_squares()).source);
  ColouredMesh moved = two_squares(), dyed = two_squares(), scaled = two_squares();
  moved.vertices[2].y() += 1e-9;
  dyed.colours[0].y() = .1;
  for (Vector3d& vertex : scaled.vertices) vertex = 2 * vertex - Vector3d(1, .5, .5);
  CHECK(scene_from(moved).source != before);
  CHECK(scene_from(dyed).source != before);
  CHECK(scene_from(scaled).source != before);
}

TEST_CASE("more pieces than a picture can number are merged by colour") {
  ColouredMesh mesh;
  for (int k = 0; k < 65540; ++k) {
    const Vector3d at(k % 256, k / 256, 0);
    add(mesh, {at, at + Vector3d(.5, 0, 0), at + Vector3d(0, .5, 0)}, k % 2 == 0 ? kRed : kBlue);
  }
  const Scene scene = scene_from(mesh);
  REQUIRE(scene.primitives.size() == 2);
  CHECK(shape_of<Mesh>(scene).triangles.size() == 32770);
  REQUIRE(scene.warnings.size() == 1);
}

TEST_CASE("meshes with nothing to see or numbers that are none are refused") {
  CHECK(error_from({}) == "holds no faces; export the model as a mesh");
  ColouredMesh mesh = two_squares();
  mesh.vertices[3].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(error_from(mesh).find("vertex 3 is not finite") == 0);
  mesh = two_squares();
  mesh.vertices[1].x() = 1e200;
  CHECK(error_from(mesh).find("vertex 1 is not finite") == 0);
  mesh = two_squares();
  mesh.colours[0].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(error_from(mesh).find("the colour of face 0 is not finite") == 0);
  mesh = two_squares();
  mesh.triangles[1][2] = 99;
  CHECK(error_from(mesh).find("a face has vertex 99, but there are 8") == 0);
  mesh = {};
  add(mesh, {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, kRed);
  CHECK(error_from(mesh).find("its faces have no area") == 0);
  mesh = two_squares();
  add_vertex(mesh, Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));  // of no face
  CHECK(error_from(mesh) == "no error");
}

}  // namespace aspect
