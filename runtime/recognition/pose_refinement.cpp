#include "runtime/recognition/pose_refinement.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "runtime/recognition/normal_equations.h"

namespace aspect {
namespace {

constexpr int kLeastBorders = 6;
constexpr int kNearRounds = 3;
constexpr double kSettled_px = 0.3;
constexpr float kMet_px = 1.5F;

// A border found at `distance_px` along the normal, in the straight picture.
struct FoundBorder {
  float distance_px = 0;
  double weight = 1;
};

std::optional<FoundBorder> find_border(const BorderPoint& point, const CameraModel& camera,
                                       const SeenColours& seen, float reach_px, bool any_outline,
                                       Behind behind) {
  const Point2d from =
      camera.bent({static_cast<double>(point.x_px), static_cast<double>(point.y_px)});
  const Point2d to = camera.bent({static_cast<double>(point.x_px + point.normal_x),
                                  static_cast<double>(point.y_px + point.normal_y)});
  const auto x = static_cast<float>(from.x), y = static_cast<float>(from.y);
  const auto step_x = static_cast<float>(to.x - from.x), step_y = static_cast<float>(to.y - from.y);
  const int reach = static_cast<int>(reach_px);
  // Blurred borders leave a pixel or two between the colours that are neither.
  constexpr int kWidest = 3;
  constexpr int kNone = -1000;
  // Beside the border that is looked for, one of the object's outline: a face seen as a sliver is
  // no region, and its neighbour reaches the outline instead.
  struct Crossing {
    int last_inside = kNone;
    float distance = 1e9F;
    void see(int t, bool inside, bool outside) {
      if (inside) {
        last_inside = t;
      } else if (outside && last_inside != kNone && t - last_inside <= kWidest) {
        const float middle = static_cast<float>(t + last_inside) / 2;
        if (std::abs(middle) < std::abs(distance)) distance = middle;
        last_inside = kNone;
      }
    }
  };
  Crossing border, outline;
  const bool any_outside = behind == Behind::anything && point.outside == kBackgroundClass;
  for (int t = -reach - kWidest; t <= reach + kWidest; ++t) {
    const auto f = static_cast<float>(t);
    ColourClass colour = seen.at(x + f * step_x, y + f * step_y);
    if (colour == SeenColours::kUnknown) continue;
    // A region may hold a surface and what stands behind it.
    if (behind == Behind::anything && colour == SeenColours::kOther && seen.has_regions())
      colour = seen.at_pixel(x + f * step_x, y + f * step_y);
    border.see(t, colour == point.inside,
               any_outside ? colour != point.inside : colour == point.outside);
    outline.see(t, colour != kBackgroundClass, colour == kBackgroundClass);
  }
  FoundBorder found{border.distance, 1};
  constexpr double kOutlineWeight = 0.3;
  if (any_outline && !any_outside && std::abs(found.distance_px) > reach_px &&
      point.outside == kBackgroundClass)
    found = {outline.distance, kOutlineWeight};
  const float best = found.distance_px;
  if (std::abs(best) > reach_px) return std::nullopt;

  // Where the colour is half-way between the two sides.
  constexpr int kSamples = 6;
  constexpr float kFirst = -2.5F;
  std::array<std::array<float, 3>, kSamples> rgb;
  for (int k = 0; k < kSamples; ++k) {
    const float t = best + kFirst + static_cast<float>(k);
    rgb[static_cast<std::size_t>(k)] = seen.rgb(x + t * step_x, y + t * step_y);
  }
  std::array<float, 3> change;
  float square = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    change[c] = rgb[kSamples - 1][c] - rgb[0][c];
    square += change[c] * change[c];
  }
  constexpr float kLeastContrast = 16;
  if (square < kLeastContrast * kLeastContrast) return found;
  std::array<float, kSamples> level;
  for (std::size_t k = 0; k < kSamples; ++k) {
    level[k] = 0;
    for (std::size_t c = 0; c < 3; ++c) level[k] += change[c] * (rgb[k][c] - rgb[0][c]) / square;
  }
  float nearest = 1e9F;
  for (std::size_t k = 0; k + 1 < kSamples; ++k) {
    if (level[k] >= 0.5F || level[k + 1] < 0.5F) continue;
    const float t = kFirst + static_cast<float>(k) + (0.5F - level[k]) / (level[k + 1] - level[k]);
    if (std::abs(t) < std::abs(nearest)) nearest = t;
  }
  if (std::abs(nearest) <= 2.5F) found.distance_px = best + nearest;
  return found;
}

struct Measured {
  std::array<double, 6> slope{};  // of the distance, by turn and shift
  double distance_px = 0;
};

// How the point's distance along its normal changes as the object turns about its centre and
// shifts, both in the camera's coordinates.
Measured measured(const BorderPoint& point, const RigidPose& pose, const Vector3d& centre,
                  const CameraModel& camera, float distance_px) {
  const Vector3d p = pose(point.point_object);
  const Vector3d arm = pose.rotation(point.point_object - centre);
  const auto nx = static_cast<double>(point.normal_x) * camera.fx_px,
             ny = static_cast<double>(point.normal_y) * camera.fy_px;
  const Vector3d by_place{nx / p[2], ny / p[2], -(nx * p[0] + ny * p[1]) / (p[2] * p[2])};
  const Vector3d by_turn = cross(arm, by_place);
  return {{by_turn[0], by_turn[1], by_turn[2], by_place[0], by_place[1], by_place[2]},
          static_cast<double>(distance_px)};
}

RigidPose moved(const RigidPose& pose, const Vector3d& centre, const std::array<double, 6>& step) {
  const Vector3d turn{step[0], step[1], step[2]};
  const Vector3d place = pose(centre) + Vector3d{step[3], step[4], step[5]};
  RigidPose next = pose;
  if (const double angle = norm(turn); angle > 0)
    next.rotation = turn_about((1 / angle) * turn, angle) * pose.rotation;
  next.translation = place - next.rotation(centre);
  return next;
}

// Border points of an earlier pose to where they are now; their normals hardly turn. False where
// one of them has left all pictures.
bool move_points(std::span<BorderPoint> points, const RigidPose& pose, const CameraModel& camera) {
  constexpr double kFarthest_px = 1e5;
  for (BorderPoint& point : points) {
    const Vector3d p = pose(point.point_object);
    if (!(p[2] > 0)) return false;
    const double x = camera.cx_px + camera.fx_px * p[0] / p[2],
                 y = camera.cy_px + camera.fy_px * p[1] / p[2];
    if (!(std::abs(x) < kFarthest_px && std::abs(y) < kFarthest_px)) return false;
    point.x_px = static_cast<float>(x);
    point.y_px = static_cast<float>(y);
  }
  return true;
}

// How far a point of the object moves, at most.
double size_of(const std::array<double, 6>& step, double radius) {
  return radius * norm({step[0], step[1], step[2]}) + norm({step[3], step[4], step[5]});
}

}  // namespace

RefinedPose refine_pose(const ObjectModel& model, const CameraModel& camera,
                        const SeenColours& seen, const Box& box, const RigidPose& start, int rounds,
                        float reach_px, RefinementScratch& scratch, Behind behind,
                        const RefinementDetail& detail) {
  RefinedPose refined;
  refined.pose = start;
  constexpr float kLeastReach_px = 3, kOutlineReach = 0.6F;
  const float first_reach_px = reach_px;
  const double size = std::max(model.radius, 1e-12);
  std::size_t count = 0;
  int rounds_drawn = 0;
  for (int round = 0; round <= rounds; ++round) {
    // Only the last one is compared with the picture cell by cell.
    const bool is_last = round == rounds;
    const int cells = is_last ? ModelDrawing::kMostCells : detail.round_cells;
    if (is_last || rounds_drawn == 0 || rounds_drawn == detail.rounds_a_drawing ||
        !move_points(std::span(scratch.points).first(count), refined.pose, camera)) {
      if (!scratch.drawing.draw(model, refined.pose, camera, box, cells)) return refined;
      count = find_border_points(model, scratch.drawing, scratch.points);
      rounds_drawn = 1;
    } else {
      ++rounds_drawn;
    }
    refined.borders_found = 0;
    const float reach = std::max(kLeastReach_px, reach_px);
    const bool near = round >= rounds - kNearRounds;
    // Tukey's bound on distances: what lies beyond is another border.
    const auto bound = static_cast<double>(reach) * 1.2;
    NormalEquations equations;
    double squares = 0, weights = 0;
    int met = 0;
    for (const BorderPoint& point : std::span(scratch.points).first(count)) {
      const std::optional<FoundBorder> border =
          find_border(point, camera, seen, reach, near, behind);
      if (!border) continue;
      met += std::abs(border->distance_px) <= kMet_px ? 1 : 0;
      ++refined.borders_found;
      const Measured m = measured(point, refined.pose, model.centre, camera, border->distance_px);
      const double share = m.distance_px / bound;
      const double inner = std::max(0.0, 1 - share * share),
                   weight = border->weight * inner * inner;
      equations.add(m.slope, m.distance_px, weight);
      squares += weight * m.distance_px * m.distance_px;
      weights += weight;
    }
    refined.borders_met =
        static_cast<float>(met) / static_cast<float>(std::max<std::size_t>(count, 1));
    refined.reprojection_px = static_cast<float>(std::sqrt(squares / std::max(weights, 1e-9)));
    if (refined.borders_found < kLeastBorders) return refined;
    if (round == rounds) {
      refined.covariance = equations.covariance(squares / std::max(1.0, weights - 6), size);
      return refined;
    }
    // A turn of one counts as a shift by the object's size: what the picture does not say stays.
    const std::optional<std::array<double, 6>> step = equations.solve(size);
    if (!step) return refined;
    refined.pose = moved(refined.pose, model.centre, *step);
    if (size_of(*step, size) * camera.fx_px < kSettled_px * refined.pose(model.centre)[2])
      round = std::max(round, near ? rounds - 1 : rounds - kNearRounds - 1);
    // Outlines are looked for from farther away again: what is a pixel or two beside the border
    // that was looked for first may be the object's whole side.
    reach_px = round == rounds - kNearRounds - 1 ? kOutlineReach * first_reach_px : 0.6F * reach_px;
  }
  return refined;
}

Agreement agreement(const ModelDrawing& drawing, const CameraModel& camera,
                    const SeenColours& seen) {
  const auto drawn_at = [&](int column, int row) {
    const bool inside =
        column >= 0 && row >= 0 && column < drawing.width() && row < drawing.height();
    return inside ? drawing.cell(column, row).colour : kBackgroundClass;
  };
  // Cells that blur may reach over.
  const int rim = drawing.cell_px() < 1.25F ? 3 : drawing.cell_px() < 2.5F ? 2 : 1;
  int either = 0, same = 0, near = 0, unknown = 0;
  for (int row = 0; row < drawing.height(); ++row)
    for (int column = 0; column < drawing.width(); ++column) {
      const ColourClass drawn = drawing.cell(column, row).colour;
      const Point2d p = camera.bent(
          {static_cast<double>(drawing.x_px(column)), static_cast<double>(drawing.y_px(row))});
      const auto x = static_cast<float>(p.x), y = static_cast<float>(p.y);
      const ColourClass of_region = seen.at(x, y);
      if (of_region == SeenColours::kUnknown) {
        unknown += drawn == kBackgroundClass ? 0 : 1;
        continue;
      }
      if (drawn == kBackgroundClass && of_region == kBackgroundClass) continue;
      ++either;
      if (of_region == drawn) {
        ++same;
        continue;
      }
      // A region may have grown over a border between two colours that are alike, and a face in
      // little light is none.
      const ColourClass of_pixel = seen.at_pixel(x, y);
      if (of_pixel == drawn && drawn != kBackgroundClass) {
        ++same;
        continue;
      }
      const auto shows_beside = [&](int right, int down) {
        const ColourClass beside = drawn_at(column + right, row + down);
        return beside != drawn && (beside == of_region || beside == of_pixel);
      };
      bool is_near = false;
      for (int d = 1; d <= rim && !is_near; ++d)
        is_near =
            shows_beside(-d, 0) || shows_beside(d, 0) || shows_beside(0, -d) || shows_beside(0, d);
      near += is_near ? 1 : 0;
    }
  if (either == 0) return {};
  // Of what is much beyond the picture's border anything could be said.
  constexpr int kMostBeyond = 4;  // of so many one is no fault
  either += std::max(0, unknown - either / kMostBeyond);
  const auto share = [&](int count) {
    return static_cast<float>(count) / static_cast<float>(either);
  };
  return {share(same), share(same + near)};
}

}  // namespace aspect
