#include "compiler/scene/colour_merging.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "compiler/scene/colour_palette.h"

namespace aspect {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr double kSameColour = 2.0 / 255;  // as surfaces are told apart (mesh_scene.cpp)
constexpr std::size_t kMostPoints = 4096;
constexpr int kMostRounds = 100;

// Shares of dark colours are noise: this much grey under each draws them together.
constexpr double kGreyBelow = 0.03;
// Black and white are as far apart as white and a faint tint, and two shades of a paint less.
constexpr double kBrightnessWeight = 0.2;

Vector4d feature_of(const Vector3d& colour) {
  const Vector3d lifted = colour.array() + kGreyBelow;
  Vector4d feature;
  feature << lifted / lifted.sum(), kBrightnessWeight * colour.sum() / 3;
  return feature;
}

struct Points {
  std::vector<Vector4d> features;
  std::vector<double> weights;
};

std::size_t nearest(const std::vector<Vector4d>& centres, const Vector4d& feature) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < centres.size(); ++k)
    if (const double distance = (centres[k] - feature).squaredNorm(); distance < least)
      least = distance, best = k;
  return best;
}

// The point that costs most where it is: with it as a further centre the cost falls.
std::size_t costliest(const Points& points, const std::vector<Vector4d>& centres) {
  std::size_t worst = 0;
  double most = -1;
  for (std::size_t i = 0; i < points.features.size(); ++i) {
    double cost = points.weights[i];
    if (!centres.empty())
      cost *= (centres[nearest(centres, points.features[i])] - points.features[i]).squaredNorm();
    if (cost > most) most = cost, worst = i;
  }
  return worst;
}

// False where nothing moves any more.
bool move_to_means(const Points& points, const std::vector<std::size_t>& cluster_of,
                   std::vector<Vector4d>& centres) {
  std::vector<Vector4d> sums(centres.size(), Vector4d::Zero());
  std::vector<double> weights(centres.size(), 0);
  for (std::size_t i = 0; i < cluster_of.size(); ++i) {
    sums[cluster_of[i]] += points.weights[i] * points.features[i];
    weights[cluster_of[i]] += points.weights[i];
  }
  bool moved = false;
  for (std::size_t k = 0; k < centres.size(); ++k) {
    if (!(weights[k] > 0)) continue;
    const Vector4d mean = sums[k] / weights[k];
    moved = moved || mean != centres[k];
    centres[k] = mean;
  }
  return moved;
}

ColourClusters clusters_of(std::span<const WeighedColour> colours,
                           const std::vector<std::size_t>& cluster_of, std::size_t count) {
  std::vector<Vector3d> sums(count, Vector3d::Zero());
  std::vector<double> weights(count, 0);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    sums[cluster_of[i]] += colours[i].weight * colours[i].colour;
    weights[cluster_of[i]] += colours[i].weight;
  }
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t k) { return !(weights[k] > 0); });
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return weights[a] > weights[b]; });
  const double whole = std::accumulate(weights.begin(), weights.end(), 0.0);
  ColourClusters clusters;
  std::vector<std::size_t> place(count, 0);
  for (const std::size_t k : order) {
    place[k] = clusters.colours.size();
    clusters.colours.push_back(sums[k] / weights[k]);
    clusters.shares.push_back(weights[k] / whole);
  }
  for (const std::size_t k : cluster_of) clusters.cluster_of.push_back(place[k]);
  return clusters;
}

std::vector<double> areas_of(const ColouredMesh& mesh) {
  std::vector<double> areas;
  for (const auto& [a, b, c] : mesh.triangles)
    areas.push_back(
        (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm());
  const double whole = std::accumulate(areas.begin(), areas.end(), 0.0);
  // Too small or too large for sums of squares: every face counts the same.
  const bool counts = whole > 0 && std::isfinite(whole);
  for (double& area : areas) area = counts ? area / whole : 1;
  return areas;
}

}  // namespace

ColourClusters cluster_colours(std::span<const WeighedColour> colours, std::size_t count) {
  Points points;
  for (const WeighedColour& one : colours) {
    points.features.push_back(feature_of(one.colour));
    // What has no area still has a colour.
    points.weights.push_back(std::max(one.weight, 1e-12));
  }
  std::vector<WeighedColour> weighed(colours.begin(), colours.end());
  for (std::size_t i = 0; i < weighed.size(); ++i) weighed[i].weight = points.weights[i];
  std::vector<Vector4d> centres;
  while (centres.size() < std::min(count, colours.size()))
    centres.push_back(points.features[costliest(points, centres)]);
  std::vector<std::size_t> cluster_of(colours.size(), 0);
  for (int round = 0; round < kMostRounds; ++round) {
    for (std::size_t i = 0; i < colours.size(); ++i)
      cluster_of[i] = nearest(centres, points.features[i]);
    if (!move_to_means(points, cluster_of, centres)) break;
  }
  return clusters_of(weighed, cluster_of, centres.size());
}

MeshColourCount count_colours(const ColouredMesh& mesh) {
  const std::vector<double> areas = areas_of(mesh);
  for (double tolerance = kSameColour;; tolerance *= 2) {
    ColourPalette palette(tolerance);
    MeshColourCount count;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Vector3d colour = mesh.colours[t].cwiseMax(0).cwiseMin(1);
      const std::size_t index = palette.find_or_add(colour);
      if (index == kMostPoints) break;
      if (index == count.colours.size()) count.colours.push_back({});
      count.colours[index].colour += areas[t] * colour;
      count.colours[index].weight += areas[t];
      count.colour_of.push_back(index);
    }
    if (palette.colours().size() > kMostPoints) continue;
    for (std::size_t k = 0; k < count.colours.size(); ++k)
      if (count.colours[k].weight > 0)
        count.colours[k].colour /= count.colours[k].weight;
      else
        count.colours[k].colour = palette.colours()[k];
    return count;
  }
}

void merge_colours(ColouredMesh& mesh, std::size_t count) {
  const MeshColourCount counted = count_colours(mesh);
  const ColourClusters clusters = cluster_colours(counted.colours, count);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    mesh.colours[t] = clusters.colours[clusters.cluster_of[counted.colour_of[t]]];
}

}  // namespace aspect
