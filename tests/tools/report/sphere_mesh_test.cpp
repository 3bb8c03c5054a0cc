// The viewing sphere as it is drawn, against what is known of spheres.
#include "tools/report/sphere_mesh.h"

#include <catch2/catch.hpp>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "tests/tools/report/report_cube.h"
#include "tools/report/aspect_colours.h"
#include "tools/report/sphere_outlines.h"

namespace aspect {
namespace {

constexpr double kPi = std::numbers::pi;

// Patches of levels 1 to 4, all without a class.
ViewSphere mixed_sphere() {
  ViewSphere sphere;
  for (int level = 0; level < 4; ++level) {
    const std::vector<PatchId> leaves = sphere.leaves();
    for (std::size_t k = 0; k < leaves.size(); k += level == 0 ? 1 : 3)
      if (sphere.patch(leaves[k]).level == level) sphere.split(leaves[k]);
  }
  return sphere;
}

SphereMesh mesh_without_classes(const ViewSphere& sphere) {
  SphereClasses classes;
  classes.class_of.assign(sphere.patch_count(), kNoClass);
  return sphere_mesh(sphere, classes);
}

SphereMesh cube_mesh() {
  return sphere_mesh(cube_model().subdivision.sphere, cube_model().sphere_classes);
}

const std::array<LookFrame, 3> kFrames = {
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
     {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}},
     {Eigen::Vector3d(2, -1, 0).normalized(), Eigen::Vector3d(1, 2, -5).normalized(),
      Eigen::Vector3d(1, 2, 1).normalized()}}};

}  // namespace

TEST_CASE("pieces of a sphere of mixed levels fill it, and Euler's formula holds") {
  for (const SphereMesh& mesh : {mesh_without_classes(mixed_sphere()), cube_mesh()}) {
    double area = 0;
    std::set<PointId> points;
    std::map<std::pair<PointId, PointId>, int> directed;
    for (const SpherePiece& piece : mesh.pieces) {
      CHECK(mesh.area_sr(piece) > -1e-9);
      area += mesh.area_sr(piece);
      const std::vector<PointId> rim = mesh.rim(piece);
      points.insert(rim.begin(), rim.end());
      for (std::size_t k = 0; k < rim.size(); ++k) ++directed[{rim[k], rim[(k + 1) % rim.size()]}];
    }
    CHECK(area == Approx(4 * kPi).epsilon(1e-9));
    // Every side is one piece's in this direction and another's in the other.
    for (const auto& [side, count] : directed) {
      CHECK(count == 1);
      CHECK(directed.count({side.second, side.first}) == 1);
    }
    CHECK(points.size() + mesh.pieces.size() == directed.size() / 2 + 2);
    CHECK(sides_of(mesh).size() == directed.size() / 2);
  }
}

TEST_CASE("aspects have the area that the compiler says") {
  const SphereMesh mesh = cube_mesh();
  std::vector<double> areas(cube_model().clusters.size(), 0);
  for (const SpherePiece& piece : mesh.pieces)
    if (piece.class_id != kNoClass)
      areas[static_cast<std::size_t>(piece.class_id)] += mesh.area_sr(piece) / (4 * kPi);
  for (std::size_t k = 0; k < areas.size(); ++k)
    CHECK(areas[k] == Approx(cube_model().clusters[k].area_assigned).margin(1e-3));
}

TEST_CASE("a projection is a disc, whatever it is seen from") {
  const SphereMesh mesh = mesh_without_classes(mixed_sphere());
  for (const LookFrame& frame : kFrames) {
    double area = 0;
    for (const auto& [aspect, outlines] : class_outlines(mesh, frame))
      for (const Outline& outline : outlines) area += area_of(outline);
    // Polygons of these levels are a few per cent less than the disc.
    CHECK(area < kPi);
    CHECK(area > 0.95 * kPi);
  }
}

TEST_CASE("projections show every place once, in its own aspect") {
  const SphereMesh mesh = cube_mesh();
  const ViewSphere& sphere = cube_model().subdivision.sphere;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-0.97, 0.97);
  for (const LookFrame& frame : kFrames) {
    const auto outlines = class_outlines(mesh, frame);
    int points = 0, right = 0;
    while (points < 300) {
      const Eigen::Vector2d at(place(random), place(random));
      if (at.norm() > 0.97) continue;
      ++points;
      std::vector<std::int32_t> found;
      for (const auto& [aspect, loops] : outlines) {
        bool inside = false;  // by crossings, as SVG's evenodd
        for (const Outline& loop : loops)
          for (std::size_t k = 0; k < loop.size(); ++k) {
            const Eigen::Vector2d &a = loop[k], &b = loop[(k + 1) % loop.size()];
            if ((a.y() > at.y()) != (b.y() > at.y()) &&
                at.x() < (b.x() - a.x()) * (at.y() - a.y()) / (b.y() - a.y()) + a.x())
              inside = !inside;
          }
        if (inside) found.push_back(aspect);
      }
      REQUIRE(found.size() == 1);
      const Eigen::Vector3d direction = at.x() * frame.right + at.y() * frame.up +
                                        std::sqrt(1 - at.squaredNorm()) * frame.towards;
      right += found[0] == cube_model().sphere_classes.at(sphere, direction) ? 1 : 0;
    }
    // Flat sides are drawn for arcs.
    CHECK(right >= 290);
  }
}

TEST_CASE("each side of a patch is drawn once") {
  const SphereMesh mesh = mesh_without_classes(mixed_sphere());
  const auto front = patch_sides(mesh, kFrames[0]);
  LookFrame behind = kFrames[0];
  behind.right = -behind.right;
  behind.towards = -behind.towards;
  // Those on the rim are in both halves, those across it are cut in two.
  std::size_t twice = 0;
  for (const MeshSide& side : sides_of(mesh)) {
    const double a = mesh.points[side.from].z(), b = mesh.points[side.to].z();
    twice += (a == 0 && b == 0) || a * b < 0 ? 1 : 0;
  }
  const std::size_t on_rim = static_cast<std::size_t>(
      std::count_if(mesh.pieces.begin(), mesh.pieces.end(), [&](const SpherePiece& piece) {
        int above = 0, below = 0;
        for (const PointId corner : piece.corners) {
          above += mesh.points[corner].z() > 0 ? 1 : 0;
          below += mesh.points[corner].z() < 0 ? 1 : 0;
        }
        return above > 0 && below > 0;
      }));
  // A cut piece has a side along the rim in each half.
  CHECK(front.size() + patch_sides(mesh, behind).size() ==
        sides_of(mesh).size() + twice + 2 * on_rim);
}

TEST_CASE("a cube's aspects lie beside each other as on a cube") {
  const auto neighbours = aspect_neighbours(cube_mesh(), cube_model().clusters.size());
  REQUIRE(neighbours.size() == 26);
  // Of one face, two or three: a face's touches those of its 4 edges, an edge's those of 2 faces
  // and 2 corners, a corner's those of 3 edges.
  const std::map<std::size_t, std::size_t> expected = {{1, 4}, {2, 4}, {3, 3}};
  std::map<std::size_t, int> of_faces;
  for (std::size_t k = 0; k < neighbours.size(); ++k) {
    const std::size_t faces = cube_model().clusters[k].contour_count;
    ++of_faces[faces];
    std::size_t touching = 0;
    for (const AspectNeighbour& neighbour : neighbours[k]) {
      const std::size_t others =
          cube_model().clusters[static_cast<std::size_t>(neighbour.aspect)].contour_count;
      // Where four meet in a point, which of them touch is a matter of chance.
      if (neighbour.gap > 0 || neighbour.border_deg < 3) continue;
      ++touching;
      CHECK(std::max(faces, others) - std::min(faces, others) == 1);
    }
    CHECK(touching == expected.at(faces));
  }
  CHECK(of_faces == std::map<std::size_t, int>{{1, 6}, {2, 12}, {3, 8}});
}

TEST_CASE("neighbours name each other, and have different colours") {
  const auto neighbours = aspect_neighbours(cube_mesh(), cube_model().clusters.size());
  const std::vector<std::size_t> colours = map_colours(neighbours);
  for (std::size_t k = 0; k < neighbours.size(); ++k) {
    for (const AspectNeighbour& neighbour : neighbours[k]) {
      const auto other = static_cast<std::size_t>(neighbour.aspect);
      CHECK(colours[other] != colours[k]);
      CHECK(std::any_of(neighbours[other].begin(), neighbours[other].end(), [&](const auto& back) {
        return static_cast<std::size_t>(back.aspect) == k &&
               back.border_deg == neighbour.border_deg && back.gap == neighbour.gap;
      }));
    }
  }
}

TEST_CASE("triangles of a divided patch have its pieces' areas") {
  const PatchDivision division{{0.25, 0.75, 1.5, 2.25}, {3, 0, kNoClass, 5}};
  const std::vector<double> shares = piece_shares(division);
  const auto at = [](double place) {
    const auto edge = static_cast<std::size_t>(place);
    Eigen::Vector3d point(0, 0, 0);
    point[static_cast<Eigen::Index>(edge % 3)] = 1 - (place - static_cast<double>(edge));
    point[static_cast<Eigen::Index>((edge + 1) % 3)] += place - static_cast<double>(edge);
    return point;
  };
  std::map<std::int32_t, double> areas;
  for (const DivisionTriangle& t : division_triangles(division)) {
    Eigen::Matrix3d corners;
    corners << division_middle(division), at(t.from), at(t.to);
    areas[t.class_id] += corners.determinant();
  }
  for (std::size_t k = 0; k < shares.size(); ++k)
    CHECK(areas[division.classes[k]] == Approx(shares[k]));
}

}  // namespace aspect
