#include "tools/explain/background_advice.h"

#include <algorithm>

namespace aspect {
namespace {

constexpr std::size_t kMostColours = 64;  // as the recogniser's

Eigen::Vector3d rgb_shares(const Eigen::Vector3d& colour) {
  return colour / colour.sum();
}

// Joined by colour.
std::vector<Face> colours_of(const Faces& faces, const VisionParameters& vision) {
  constexpr double kSame = 1e-3;  // of a share: rounding
  std::vector<Face> colours;
  for (const Face& face : faces.all) {
    if (intensity_seen(face.colour, vision) <= vision.intensity_min) continue;
    const auto same = std::find_if(colours.begin(), colours.end(), [&](const Face& other) {
      return (rgb_shares(other.colour) - rgb_shares(face.colour)).cwiseAbs().maxCoeff() < kSame;
    });
    if (same == colours.end())
      colours.push_back(face);
    else
      same->primitives.insert(same->primitives.end(), face.primitives.begin(),
                              face.primitives.end());
  }
  std::stable_sort(colours.begin(), colours.end(), [](const Face& a, const Face& b) {
    return a.primitives.size() > b.primitives.size();
  });
  colours.resize(std::min(colours.size(), kMostColours));
  return colours;
}

std::vector<Eigen::Vector3d> paints_of(const std::vector<Face>& faces) {
  std::vector<Eigen::Vector3d> paints;
  for (const Face& face : faces) paints.push_back(face.colour);
  return paints;
}

}  // namespace

std::vector<PaletteColour> palette_before(const BackgroundPictures& pictures,
                                          const VisionParameters& vision) {
  std::vector<PaletteColour> colours = palette();
  std::vector<Eigen::Vector3d> paints;
  for (const PaletteColour& colour : colours) paints.push_back(colour.colour);
  const auto presence = presence_of(paints, pictures.rgb, vision.intensity_min);
  for (std::size_t k = 0; k < colours.size(); ++k) {
    colours[k].presence = presence[k];
    colours[k].commonness = commonness_of(presence[k]);
  }
  return colours;
}

BackgroundColours background_colours(const Faces& faces, const BackgroundPictures& pictures,
                                     std::span<const PaletteColour> palette,
                                     const VisionParameters& vision) {
  BackgroundColours report{pictures.folder, pictures.rgb.size(), {}};
  const std::vector<Face> colours = colours_of(faces, vision);
  const auto presence = presence_of(paints_of(colours), pictures.rgb, vision.intensity_min);
  for (std::size_t k = 0; k < colours.size(); ++k)
    report.colours.push_back({colours[k], presence[k], commonness_of(presence[k]), {}});
  std::stable_sort(report.colours.begin(), report.colours.end(), [](const auto& a, const auto& b) {
    return a.presence.pixels > b.presence.pixels;
  });
  std::vector<Eigen::Vector3d> paints;
  for (const BackgroundColour& colour : report.colours) paints.push_back(colour.face.colour);
  std::size_t changes = 0;
  for (std::size_t k = 0; k < report.colours.size() && changes < kMostBetterPaints; ++k) {
    BackgroundColour& colour = report.colours[k];
    if (colour.commonness != Commonness::common) continue;
    const auto better = best_paint(palette, k, paints, vision);
    if (!better || better->paint.commonness >= colour.commonness) continue;
    colour.better = better;
    paints[k] = better->paint.colour;
    ++changes;
  }
  return report;
}

}  // namespace aspect
