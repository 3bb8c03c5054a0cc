#include "tools/explain/confusions.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace aspect {
namespace {

using FacePair = std::pair<std::size_t, std::size_t>;

// The two faces whose colours are nearest, if the contours show none in common.
std::optional<FacePair> mistaken(const MatchedFaces& match, const Faces& faces,
                                 const VisionParameters& vision) {
  std::optional<FacePair> nearest;
  double least = 0;
  for (const std::size_t seen : match.seen) {
    for (const std::size_t believed : match.believed) {
      if (seen == believed) return std::nullopt;
      const double separation =
          colour_separation(faces.all[seen].colour, faces.all[believed].colour, vision);
      if (nearest && separation >= least) continue;
      least = separation;
      nearest = std::minmax(seen, believed);
    }
  }
  return nearest;
}

std::vector<Face> listed(const std::set<std::size_t>& numbers, const Faces& faces) {
  std::vector<Face> list;
  for (const std::size_t number : numbers) list.push_back(faces.all[number]);
  return list;
}

}  // namespace

std::vector<AspectConfusion> aspect_confusions(const std::vector<Trial>& trials,
                                               const Faces& faces) {
  struct Sum {
    AspectConfusion confusion;
    Eigen::Vector3d from{0, 0, 0}, believed{0, 0, 0};
    std::set<std::size_t> faces, faces_believed;
  };
  std::map<std::pair<std::int32_t, std::int32_t>, Sum> sums;
  for (const Trial& trial : trials) {
    if (!trial.is_wrong() || !trial.found) continue;
    Sum& sum = sums[{trial.outcome.right_class, trial.found_class}];
    ++sum.confusion.views;
    sum.from += trial.outcome.direction;
    sum.believed += trial.found_view;
    for (const MatchedFaces& match : trial.contours) {
      sum.faces.insert(match.seen.begin(), match.seen.end());
      sum.faces_believed.insert(match.believed.begin(), match.believed.end());
    }
  }
  std::vector<AspectConfusion> confusions;
  for (auto& [classes, sum] : sums) {
    sum.confusion.aspect = classes.first;
    sum.confusion.taken_for = classes.second;
    sum.confusion.seen_from = sum.from.normalized();
    sum.confusion.believed_from = sum.believed.normalized();
    sum.confusion.faces = listed(sum.faces, faces);
    sum.confusion.faces_believed = listed(sum.faces_believed, faces);
    confusions.push_back(std::move(sum.confusion));
  }
  std::stable_sort(confusions.begin(), confusions.end(),
                   [](const auto& a, const auto& b) { return a.views > b.views; });
  return confusions;
}

std::vector<FaceConfusion> face_confusions(const std::vector<Trial>& trials, const Faces& faces,
                                           const VisionParameters& vision) {
  std::map<FacePair, std::size_t> counts;
  for (const Trial& trial : trials) {
    std::set<FacePair> pairs;
    for (const MatchedFaces& match : trial.contours)
      if (const auto pair = mistaken(match, faces, vision)) pairs.insert(*pair);
    for (const FacePair& pair : pairs) ++counts[pair];
  }
  std::vector<FaceConfusion> confusions;
  for (const auto& [pair, views] : counts)
    confusions.push_back(
        {pair.first, pair.second, views,
         colour_separation(faces.all[pair.first].colour, faces.all[pair.second].colour, vision)});
  std::stable_sort(confusions.begin(), confusions.end(),
                   [](const auto& a, const auto& b) { return a.views > b.views; });
  return confusions;
}

}  // namespace aspect
