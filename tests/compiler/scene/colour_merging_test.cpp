#include "compiler/scene/colour_merging.h"

#include <catch2/catch.hpp>
#include <random>
#include <set>

namespace aspect {
namespace {

using Eigen::Vector3d;

constexpr std::array<std::array<double, 3>, 4> kPaints = {
    {{.85, .1, .1}, {.1, .7, .15}, {.1, .15, .8}, {.85, .85, .85}}};

Vector3d shade(std::size_t paint, double light) {
  return light * Vector3d(kPaints[paint][0], kPaints[paint][1], kPaints[paint][2]);
}

// Each paint in 50 shades, from a third of its light to all of it.
std::vector<WeighedColour> shaded_paints() {
  std::vector<WeighedColour> colours;
  for (std::size_t k = 0; k < 200; ++k)
    colours.push_back({shade(k % 4, .33 + .67 * static_cast<double>(k / 4) / 49), 1});
  return colours;
}

std::vector<WeighedColour> random_colours(unsigned seed, std::size_t count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> channel(0, 1);
  std::vector<WeighedColour> colours;
  for (std::size_t k = 0; k < count; ++k)
    colours.push_back({{channel(random), channel(random), channel(random)}, channel(random)});
  return colours;
}

// Triangles side by side, each with that area and colour.
ColouredMesh mesh_of(const std::vector<WeighedColour>& colours) {
  ColouredMesh mesh;
  mesh.parts.push_back({});
  for (const auto& [colour, area] : colours) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vector3d& corner : {Vector3d(0, 0, 0), Vector3d(2 * area, 0, 0), Vector3d(0, 1, 0)})
      add_vertex(mesh, corner);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.colours.push_back(colour);
    mesh.part_of.push_back(0);
  }
  return mesh;
}

}  // namespace

TEST_CASE("the shades of each paint become one colour, and no two paints do") {
  const ColourClusters clusters = cluster_colours(shaded_paints(), 4);
  REQUIRE(clusters.colours.size() == 4);
  for (std::size_t k = 0; k < 200; ++k) CHECK(clusters.cluster_of[k] == clusters.cluster_of[k % 4]);
  CHECK(std::set(clusters.cluster_of.begin(), clusters.cluster_of.begin() + 4).size() == 4);
  for (const double share : clusters.shares) CHECK(share == Approx(.25));
}

TEST_CASE("a small part of another paint gets a colour before a large one gets two") {
  std::vector<WeighedColour> colours = shaded_paints();
  for (std::size_t k = 0; k < colours.size(); ++k) colours[k].weight = k % 4 == 2 ? .05 : 1;
  const ColourClusters clusters = cluster_colours(colours, 4);
  for (std::size_t k = 0; k < 200; ++k) CHECK(clusters.cluster_of[k] == clusters.cluster_of[k % 4]);
}

TEST_CASE("a cluster's colour and share are those of what is in it, and the heaviest comes first") {
  const auto seed = GENERATE(1U, 2U, 3U);
  const std::vector<WeighedColour> colours = random_colours(seed, 500);
  const ColourClusters clusters = cluster_colours(colours, 9);
  REQUIRE(clusters.colours.size() == 9);
  double whole = 0;
  std::vector<Vector3d> sums(9, Vector3d::Zero());
  std::vector<double> weights(9, 0);
  for (std::size_t k = 0; k < colours.size(); ++k) {
    sums[clusters.cluster_of[k]] += colours[k].weight * colours[k].colour;
    weights[clusters.cluster_of[k]] += colours[k].weight;
    whole += colours[k].weight;
  }
  for (std::size_t k = 0; k < 9; ++k) {
    CHECK((sums[k] / weights[k] - clusters.colours[k]).norm() < 1e-9);
    CHECK(weights[k] / whole == Approx(clusters.shares[k]));
    if (k > 0) CHECK(clusters.shares[k] <= clusters.shares[k - 1]);
  }
  const ColourClusters again = cluster_colours(colours, 9);
  CHECK(again.cluster_of == clusters.cluster_of);
  CHECK(again.colours == clusters.colours);
}

TEST_CASE("more clusters leave less of a difference") {
  const std::vector<WeighedColour> colours = random_colours(7, 400);
  double before = 1e9;
  for (const std::size_t count : {1U, 4U, 16U, 64U}) {
    const ColourClusters clusters = cluster_colours(colours, count);
    double cost = 0;
    for (std::size_t k = 0; k < colours.size(); ++k)
      cost += colours[k].weight *
              (colours[k].colour - clusters.colours[clusters.cluster_of[k]]).squaredNorm();
    CHECK(cost < .8 * before);
    before = cost;
  }
}

TEST_CASE("a mesh of fewer colours keeps them, and one colour is the mean by area") {
  const Vector3d red(.85, .1, .1), blue(.1, .1, .9);
  ColouredMesh mesh = mesh_of({{red, 3}, {blue, 1}, {red, 2}});
  const std::vector<Vector3d> before = mesh.colours;
  merge_colours(mesh, 8);
  for (std::size_t t = 0; t < before.size(); ++t)
    CHECK((mesh.colours[t] - before[t]).norm() < 1e-12);
  merge_colours(mesh, 1);
  for (const Vector3d& colour : mesh.colours) CHECK((colour - (5 * red + blue) / 6).norm() < 1e-12);
}

TEST_CASE("many thousand colours are merged as well, whatever their areas are") {
  std::vector<WeighedColour> colours = random_colours(5, 60000);
  for (const double scale : {1.0, 0.0, 1e200, 1e-200}) {
    std::vector<WeighedColour> scaled = colours;
    for (WeighedColour& colour : scaled) colour.weight *= scale;
    ColouredMesh mesh = mesh_of(scaled);
    CHECK(count_colours(mesh).colours.size() <= 4096);
    merge_colours(mesh, 6);
    std::set<std::array<double, 3>> left;
    for (const Vector3d& colour : mesh.colours) {
      CHECK(colour.allFinite());
      left.insert({colour.x(), colour.y(), colour.z()});
    }
    CHECK(left.size() == 6);
  }
}

}  // namespace aspect
