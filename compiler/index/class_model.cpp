#include "compiler/index/class_model.h"

#include <algorithm>
#include <cmath>

#include "compiler/index/contour_types.h"

namespace aspect {
namespace {

double score_of(Scoring scoring, const ClusterView& view) {
  return scoring == Scoring::area ? view.weight : 1.0;
}

// A surface belongs to a contour where it makes up at least this share of its pixels.
constexpr double kLeastSurfaceShare = 0.02;

std::vector<std::uint16_t> main_surfaces(const std::map<std::uint16_t, double>& pixels_of) {
  double total = 0;
  for (const auto& [surface, pixels] : pixels_of) total += pixels;
  std::vector<std::uint16_t> surfaces;
  for (const auto& [surface, pixels] : pixels_of)
    if (pixels >= kLeastSurfaceShare * total) surfaces.push_back(surface);
  return surfaces;
}

std::size_t nearest_to_mean(const Subdivision& subdivision, const Cluster& cluster) {
  Eigen::Vector3d mean(0, 0, 0);
  for (const ClusterView& view : cluster.views)
    mean += view.weight * subdivision.direction(view.vertex);
  std::size_t best = 0;
  double most = -2;
  for (std::size_t i = 0; i < cluster.views.size(); ++i) {
    const double along = mean.dot(subdivision.direction(cluster.views[i].vertex));
    if (along <= most) continue;
    most = along;
    best = i;
  }
  return best;
}

}  // namespace

std::vector<TypeAttributes> contour_samples(const Subdivision& subdivision,
                                            std::span<const Cluster> clusters) {
  std::vector<TypeAttributes> samples;
  for (const Cluster& cluster : clusters)
    for (const ClusterView& view : cluster.views)
      for (const ObservedContour& contour : subdivision.views[number(view.vertex)].contours)
        if (contour.external) samples.push_back(type_attributes(contour.feature));
  return samples;
}

ClassDescription describe_class(const Subdivision& subdivision, const Cluster& cluster,
                                std::span<const TypeAttributes> types, Scoring scoring) {
  ClassDescription description;
  description.area_fraction = cluster.area_fraction;
  description.view_count = cluster.views.size();
  description.typical_view = nearest_to_mean(subdivision, cluster);
  description.contours.resize(cluster.contour_count);
  std::vector<std::map<std::uint16_t, double>> pixels_of(cluster.contour_count);
  const auto views = static_cast<double>(cluster.views.size());
  for (const ClusterView& view : cluster.views) {
    const ObservedView& observed = subdivision.views[number(view.vertex)];
    for (std::size_t i = 0; i < cluster.contour_count; ++i) {
      const ObservedContour& contour = observed.contours[i];
      ContourDescription& named = description.contours[view.names[i]];
      double& score = named.score_of_type[nearest_type(types, type_attributes(contour.feature))];
      score = scoring == Scoring::none ? 1.0 : score + score_of(scoring, view);
      for (std::size_t channel = 0; channel < 3; ++channel)
        named.share[channel] += static_cast<double>(contour.feature.share[channel]) / views;
      for (std::size_t axis = 0; axis < 3; ++axis)
        named.centre_object[static_cast<Eigen::Index>(axis)] +=
            static_cast<double>(contour.centre_object[axis]) / views;
      for (const SurfaceShare& share : contour.surfaces)
        pixels_of[view.names[i]][share.surface] += share.pixels;
    }
  }
  for (std::size_t k = 0; k < cluster.contour_count; ++k)
    description.contours[k].surfaces = main_surfaces(pixels_of[k]);
  return description;
}

DescribedClasses describe_classes(const Subdivision& subdivision, std::span<const Cluster> clusters,
                                  const CompileOptions& options) {
  DescribedClasses described;
  described.types = find_contour_types(contour_samples(subdivision, clusters),
                                       static_cast<std::size_t>(options.contour_types));
  for (const Cluster& cluster : clusters)
    described.classes.push_back(
        describe_class(subdivision, cluster, described.types, options.scoring));
  return described;
}

std::vector<std::size_t> choose_key_views(const Subdivision& subdivision, const Cluster& cluster,
                                          std::size_t typical_view, double spacing_rad) {
  const auto position = [&](std::size_t i) -> const Eigen::Vector3d& {
    return subdivision.direction(cluster.views[i].vertex);
  };
  std::vector<double> distance(cluster.views.size(), 4);
  std::vector<std::size_t> chosen{typical_view};
  const double spacing = 2 * std::sin(spacing_rad / 2);
  for (;;) {
    std::size_t farthest = 0;
    for (std::size_t i = 0; i < cluster.views.size(); ++i) {
      distance[i] = std::min(distance[i], (position(i) - position(chosen.back())).norm());
      if (distance[i] > distance[farthest]) farthest = i;
    }
    if (distance[farthest] <= spacing) return chosen;
    chosen.push_back(farthest);
  }
}

}  // namespace aspect
