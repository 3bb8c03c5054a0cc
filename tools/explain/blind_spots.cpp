#include "tools/explain/blind_spots.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "compiler/aspects/observer.h"
#include "compiler/viewsphere/patch_division.h"
#include "tools/eval/view_error.h"

namespace aspect {
namespace {

constexpr double kSpotRadius_rad = 20 * std::numbers::pi / 180;
constexpr std::size_t kMostSpots = 8, kExaminedPatches = 5;
constexpr std::size_t kVisible_px = 12;

struct Piece {
  Eigen::Vector3d centre;
  std::vector<Eigen::Vector3d> corners;
  double share = 0;
};

struct Gathering {
  std::vector<const Piece*> pieces;
  double share = 0;
};

// Largest pieces first; each joins the first gathering whose first piece is near.
std::vector<Gathering> gather(std::vector<Piece>& pieces) {
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.share > b.share; });
  std::vector<Gathering> all;
  for (const Piece& piece : pieces) {
    auto near = std::find_if(all.begin(), all.end(), [&](const Gathering& gathering) {
      return angle_rad(gathering.pieces.front()->centre, piece.centre) < kSpotRadius_rad;
    });
    if (near == all.end()) near = all.insert(all.end(), Gathering{});
    near->pieces.push_back(&piece);
    near->share += piece.share;
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Gathering& a, const Gathering& b) { return a.share > b.share; });
  return all;
}

Spot spot_of(const Gathering& gathering) {
  Spot spot;
  Eigen::Vector3d sum(0, 0, 0);
  for (const Piece* piece : gathering.pieces) sum += piece->share * piece->centre;
  spot.centre = sum.normalized();
  spot.share = gathering.share;
  for (const Piece* piece : gathering.pieces)
    for (const Eigen::Vector3d& corner : piece->corners)
      spot.radius_deg =
          std::max(spot.radius_deg, angle_rad(spot.centre, corner) * 180 / std::numbers::pi);
  return spot;
}

// What one corner of a patch shows.
struct Corner {
  ObservedView view;
  std::set<std::size_t> visible, lost;  // faces; lost: too small or thin to become a contour
};

Corner look(Observer& observer, const Faces& faces, const Eigen::Vector3d& direction) {
  Corner corner;
  corner.view = observer.observe(direction);
  std::map<std::size_t, std::size_t> pixels;
  for (const std::uint16_t id : observer.picture().surface)
    if (id != 0) ++pixels[faces.face_of[id]];
  std::map<std::size_t, std::size_t> kept;
  for (const ObservedContour& contour : corner.view.contours)
    for (const SurfaceShare& share : contour.surfaces)
      kept[faces.face_of[share.surface]] += share.pixels;
  for (const auto& [face, count] : pixels) {
    if (count < kVisible_px) continue;
    corner.visible.insert(face);
    if (2 * kept[face] < count) corner.lost.insert(face);
  }
  return corner;
}

std::string reason_of(const std::vector<Corner>& corners, const CompileOptions& options) {
  const auto any = [&](const auto& test) {
    return std::any_of(corners.begin(), corners.end(), test);
  };
  const Corner& first = corners.front();
  if (any([](const Corner& c) { return c.view.external_count == 0; }))
    return "nothing is seen: dark surfaces, or the object is out of the picture";
  if (any([&](const Corner& c) { return c.view.external_count != first.view.external_count; })) {
    if (any([](const Corner& c) { return !c.lost.empty(); }))
      return "contours too small: a sliver is counted from one side only";
    return "straddles a border between aspects";
  }
  if (any([&](const Corner& c) { return c.visible != first.visible; }))
    return "straddles a border between aspects";
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const double cost = match_graphs(corners[k].view, corners[(k + 1) % corners.size()].view,
                                     options.match_scales, options.match_limits())
                            .cost;
    if (!(cost <= options.cluster_threshold))
      return "no uniform patch: the views differ too much; raise --level or --cluster-threshold";
  }
  return "an aspect too small to be kept; lower --small-cluster or raise --max-index-kib";
}

// Van Oosterom and Strackee, "The solid angle of a plane triangle", 1983.
double area_sr(const SphereMap::Corners& corners) {
  const auto& [a, b, c] = corners;
  return 2 * std::atan2(dot(a, cross(b - a, c - a)), 1 + dot(a, b) + dot(b, c) + dot(c, a));
}

// How much of a patch is of no class.
double blind_share(const SphereMap::Leaf& leaf) {
  if (leaf.division == nullptr) return leaf.class_id == SphereMap::kNone ? 1 : 0;
  PatchDivision division;
  for (std::size_t k = 0; k < leaf.division->count; ++k) {
    division.places.push_back(static_cast<double>(leaf.division->places[k]) /
                              SphereMapFormat::kSteps);
    division.classes.push_back(leaf.division->classes[k]);
  }
  const std::vector<double> shares = piece_shares(division);
  double blind = 0;
  for (std::size_t k = 0; k < shares.size(); ++k)
    if (division.classes[k] == kNoClass) blind += shares[k];
  return blind;
}

std::string commonest_reason(const Gathering& gathering, Observer& observer, const Faces& faces,
                             const CompileOptions& options) {
  std::map<std::string, double> weights;
  for (std::size_t k = 0; k < std::min(kExaminedPatches, gathering.pieces.size()); ++k) {
    const Piece& piece = *gathering.pieces[k];
    std::vector<Corner> corners;
    for (const Eigen::Vector3d& corner : piece.corners)
      corners.push_back(look(observer, faces, corner));
    weights[reason_of(corners, options)] += piece.share;
  }
  return std::max_element(weights.begin(), weights.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

}  // namespace

BlindSpots find_blind_spots(const EvaluatedObject& object, const Faces& faces,
                            const CompileOptions& options) {
  BlindSpots found;
  std::vector<Piece> pieces;
  for (const SphereMap::Leaf& leaf : object.index.sphere_map.leaves()) {
    const double blind = blind_share(leaf);
    if (blind == 0) continue;
    Piece piece;
    Eigen::Vector3d sum(0, 0, 0);
    for (const Vector3d& corner : leaf.corners) {
      piece.corners.emplace_back(corner[0], corner[1], corner[2]);
      sum += piece.corners.back();
    }
    piece.centre = sum.normalized();
    piece.share = blind * area_sr(leaf.corners) / (4 * std::numbers::pi);
    found.share += piece.share;
    pieces.push_back(std::move(piece));
  }
  Observer observer(object.renderer, object.scene.studio, options.vision);
  for (const Gathering& gathering : gather(pieces)) {
    if (found.spots.size() == kMostSpots) break;
    found.spots.push_back(spot_of(gathering));
    found.spots.back().reason = commonest_reason(gathering, observer, faces, options);
  }
  return found;
}

std::vector<Spot> failing_spots(const std::vector<Trial>& trials) {
  std::vector<Piece> pieces;
  for (const Trial& trial : trials)
    if (trial.is_wrong())
      pieces.push_back({trial.outcome.direction,
                        {trial.outcome.direction},
                        1 / static_cast<double>(trials.size())});
  std::vector<Spot> spots;
  for (const Gathering& gathering : gather(pieces)) {
    if (spots.size() == kMostSpots) break;
    spots.push_back(spot_of(gathering));
  }
  return spots;
}

}  // namespace aspect
