#include "tests/tools/doctor/sick_meshes.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <stdexcept>

#include "compiler/viewsphere/viewsphere.h"
#include "tests/compiler/aspects/symmetric_scenes.h"

namespace aspect {
namespace {

void add_cuboid(ColouredMesh& mesh, const Eigen::Vector3d& least, const Eigen::Vector3d& most,
                const std::vector<Eigen::Vector3d>& colours) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int k = 0; k < 8; ++k)
    add_vertex(mesh, {k & 4 ? most.x() : least.x(), k & 2 ? most.y() : least.y(),
                      k & 1 ? most.z() : least.z()});
  constexpr std::uint32_t kFaces[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                          {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
  for (std::size_t face = 0; face < 6; ++face) {
    const auto& [a, b, c, d] = kFaces[face];
    for (const auto& [p, q, r] : {std::array{a, b, c}, std::array{a, c, d}}) {
      mesh.triangles.push_back({first + p, first + q, first + r});
      mesh.colours.push_back(colours[face % colours.size()]);
      mesh.part_of.push_back(0);
    }
  }
}

}  // namespace

void add_cuboid(ColouredMesh& mesh, const Eigen::Vector3d& least, const Eigen::Vector3d& most) {
  std::vector<Eigen::Vector3d> colours;
  for (int k = 0; k < 6; ++k) colours.push_back(test_colour(k));
  add_cuboid(mesh, least, most, colours);
}

void add_cuboid(ColouredMesh& mesh, const Eigen::Vector3d& least, const Eigen::Vector3d& most,
                const Eigen::Vector3d& colour) {
  add_cuboid(mesh, least, most, std::vector{colour});
}

ColouredMesh cuboid(const Eigen::Vector3d& least, const Eigen::Vector3d& most) {
  ColouredMesh mesh;
  mesh.parts.push_back({});
  add_cuboid(mesh, least, most);
  return mesh;
}

ColouredMesh dented_ball(unsigned seed) {
  ViewSphere sphere;
  for (int level = 0; level < 2; ++level)
    for (const PatchId leaf : sphere.leaves()) sphere.split(leaf);
  std::mt19937 random(seed);
  ColouredMesh mesh;
  mesh.parts.push_back({});
  for (std::size_t k = 0; k < sphere.vertex_count(); ++k)
    add_vertex(mesh, (0.8 + 0.2 * static_cast<double>(random()) / 4294967296.0) *
                         sphere.position(static_cast<VertexId>(k)));
  for (const PatchId leaf : sphere.leaves()) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = static_cast<std::uint32_t>(sphere.patch(leaf).corners[k]);
    const Eigen::Vector3d &a = mesh.vertices[corners[0]], &b = mesh.vertices[corners[1]],
                          &c = mesh.vertices[corners[2]];
    if (a.dot(b.cross(c)) < 0) std::swap(corners[1], corners[2]);
    mesh.triangles.push_back(corners);
    mesh.colours.push_back(test_colour(0));
    mesh.part_of.push_back(0);
  }
  return mesh;
}

const std::vector<Eigen::Vector3d>& ball_paints() {
  static const std::vector<Eigen::Vector3d> kPaints = {
      {.85, .12, .1}, {.1, .55, .2}, {.12, .2, .8}, {.9, .8, .1}, {.85, .85, .85}};
  return kPaints;
}

ColouredMesh shaded_ball() {
  constexpr std::uint32_t kRows = 40, kColumns = 80;
  std::mt19937 random(3);
  ColouredMesh mesh;
  for (std::size_t k = 0; k < ball_paints().size(); ++k) mesh.parts.push_back({});
  for (std::uint32_t row = 0; row <= kRows; ++row)
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const double polar = std::numbers::pi * row / kRows;
      const double turn = 2 * std::numbers::pi * column / kColumns;
      add_vertex(mesh, {std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn),
                        1.2 * std::cos(polar)});
    }
  const Eigen::Vector3d lamp = Eigen::Vector3d(.5, .4, .77).normalized();
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Eigen::Vector3d middle = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3;
    const double turn = std::atan2(middle.y(), middle.x()) / std::numbers::pi;  // -1..1
    const auto quarter = static_cast<std::uint32_t>(std::clamp(2 * turn + 2, 0.0, 3.0));
    const std::uint32_t paint = std::abs(middle.z()) > .85 ? 4 : quarter;
    const double light = .35 + .65 * std::max(0.0, middle.normalized().dot(lamp));
    Eigen::Vector3d colour = light * ball_paints()[paint];
    for (double& channel : colour) {
      const double noise = static_cast<double>(random() % 9) - 4;  // grey values
      channel = std::clamp(std::round(255 * channel + noise), 0.0, 255.0) / 255;
    }
    mesh.triangles.push_back({a, b, c});
    mesh.colours.push_back(colour);
    mesh.part_of.push_back(paint);
  };
  for (std::uint32_t row = 0; row < kRows; ++row)
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const std::uint32_t a = row * kColumns + column;
      const std::uint32_t b = row * kColumns + (column + 1) % kColumns;
      if (row > 0) add(a, a + kColumns, b);
      if (row + 1 < kRows) add(b, a + kColumns, b + kColumns);
    }
  return mesh;
}

std::size_t plain_open_edges(const ColouredMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> count;
  for (const auto& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      ++count[std::minmax<std::uint32_t>({triangle[k], triangle[(k + 1) % 3]})];
  return static_cast<std::size_t>(
      std::count_if(count.begin(), count.end(), [](const auto& edge) { return edge.second == 1; }));
}

void erase_triangle(ColouredMesh& mesh, std::size_t triangle) {
  const auto at = static_cast<std::ptrdiff_t>(triangle);
  mesh.triangles.erase(mesh.triangles.begin() + at);
  mesh.colours.erase(mesh.colours.begin() + at);
  mesh.part_of.erase(mesh.part_of.begin() + at);
}

void repeat_triangle(ColouredMesh& mesh, std::size_t triangle) {
  mesh.triangles.push_back(mesh.triangles[triangle]);
  mesh.colours.push_back(mesh.colours[triangle]);
  mesh.part_of.push_back(mesh.part_of[triangle]);
}

std::string obj_text(const ColouredMesh& mesh) {
  std::string text;
  for (const Eigen::Vector3d& v : mesh.vertices)
    text += fmt::format("v {} {} {}\n", v.x(), v.y(), v.z());
  for (const auto& [a, b, c] : mesh.triangles)
    text += fmt::format("f {} {} {}\n", a + 1, b + 1, c + 1);
  return text;
}

std::vector<std::string> codes_of(const std::vector<Finding>& findings) {
  std::vector<std::string> codes;
  for (const Finding& finding : findings) codes.emplace_back(finding.code);
  std::sort(codes.begin(), codes.end());
  return codes;
}

const Finding& finding_of(const std::vector<Finding>& findings, const std::string& code) {
  for (const Finding& finding : findings)
    if (finding.code == code) return finding;
  throw std::runtime_error("no finding " + code);
}

}  // namespace aspect
