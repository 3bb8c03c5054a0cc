// Steps: candidates from the known views; their axes, to which those of a cube are added; for each
// axis, whether any angle does, else the largest fold that does: first judged by known views, then
// by rendering. An axis is tried along the cube's axis next to it before its own estimate, which is
// improved by rendered views. Two turns about different axes make any finite group, so few are
// rendered; the rest are products.
#include "compiler/aspects/symmetry.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "compiler/aspects/rotation_group.h"
#include "compiler/aspects/symmetry_candidates.h"

namespace aspect {
namespace {

constexpr std::array kFolds = {36, 32, 30, 24, 20, 18, 16, 15, 14, 13, 12,
                               11, 10, 9,  8,  7,  6,  5,  4,  3,  2};
constexpr std::array kAnyAngles_rad = {0.61, 1.13, 1.87, 2.41, 2.95};
constexpr double kEnough = 0.8;        // likeness in known views
constexpr double kMostUnequal = 0.03;  // share of the rendered views
constexpr double kNearAxis_rad = 5 * std::numbers::pi / 180;
constexpr std::size_t kMostRendered = 600;
constexpr std::size_t kRefiningViews = 24;

double axis_angle_rad(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

class SymmetrySearch {
 public:
  SymmetrySearch(const Workshop& workshop, const Subdivision& subdivision)
      : workshop_(workshop), known_(subdivision, workshop.studio.at), observers_([&workshop] {
          return Observer(workshop.renderer, workshop.studio, workshop.options.vision);
        }) {}

  Symmetries run() {
    if (known_.samples().empty()) return {};
    for (const Eigen::Vector3d& axis : axes()) {
      if (is_over()) break;
      if (try_any_angle(axis)) {
        found_.axes = {round_axis_};
        complete_round_object();
        break;
      }
      try_folds(axis);
    }
    if (found_.axes.empty()) {
      const std::vector<Eigen::Quaterniond> elements = group_.elements();
      found_.rotations.assign(elements.begin() + 1, elements.end());
    }
    found_.views_rendered = rendered_;
    return found_;
  }

 private:
  // Cube axes first: they need no refinement, and an exact one makes an estimate superfluous.
  std::vector<Eigen::Vector3d> axes() const {
    std::vector<Eigen::Vector3d> all = cube_axes();
    for (const Eigen::Quaterniond& candidate : known_.candidates()) {
      const Eigen::Vector3d axis = Eigen::AngleAxisd(candidate).axis();
      const bool is_known = std::any_of(all.begin(), all.end(), [&](const Eigen::Vector3d& other) {
        return axis_angle_rad(axis, other) < kNearAxis_rad / 2;
      });
      if (!is_known) all.push_back(axis);
    }
    return all;
  }

  Camera turned_camera(VertexId vertex, const Eigen::Quaterniond& rotation) const {
    const Studio& studio = workshop_.studio;
    Camera camera = camera_at(studio, known_.view(vertex).direction);
    const Eigen::Matrix3d turn = rotation.toRotationMatrix();
    camera.camera_from_object = camera.camera_from_object * turn.transpose();
    camera.position_object = studio.at + turn * (camera.position_object - studio.at);
    return camera;
  }

  // Every view takes its time; a search that is cut short finds fewer symmetries.
  bool is_over() const {
    return rendered_ > kMostRendered || (workshop_.stop != nullptr && workshop_.stop->load());
  }

  // Views of samples [first, end), turned.
  std::vector<ObservedView> render(const Eigen::Quaterniond& rotation, std::size_t first,
                                   std::size_t end) {
    std::vector<ObservedView> views(end - first);
    tbb::parallel_for(first, end, [&](std::size_t k) {
      views[k - first] = observers_.local().observe(turned_camera(known_.samples()[k], rotation));
    });
    rendered_ += views.size();
    return views;
  }

  bool verify(const Eigen::Quaterniond& rotation) {
    constexpr std::size_t kPortion = 8;
    const std::size_t count = known_.samples().size();
    const auto most = static_cast<std::size_t>(kMostUnequal * static_cast<double>(count));
    std::size_t unequal = 0;
    for (std::size_t first = 0; first < count; first += kPortion) {
      const std::size_t end = std::min(first + kPortion, count);
      const std::vector<ObservedView> views = render(rotation, first, end);
      for (std::size_t k = first; k < end; ++k)
        if (!are_equal_views(known_.view(known_.samples()[k]), views[k - first])) ++unequal;
      if (unequal > most || is_over()) return false;
    }
    return true;
  }

  bool is_likely(const Eigen::Vector3d& axis, double angle_rad) const {
    return known_.likeness(Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, axis)), kEnough) > 0;
  }

  // All powers of a turn must be likely; a few tell.
  bool is_likely(const Eigen::Vector3d& axis, int fold) const {
    for (int k = 1; k <= std::min(fold / 2, 6); ++k)
      if (!is_likely(axis, 2 * std::numbers::pi * k / fold)) return false;
    return true;
  }

  // The axis of the turn that the rendered landmarks ask for.
  Eigen::Vector3d refined(Eigen::Vector3d axis, double angle_rad) {
    for (int round = 0; round < 3; ++round) {
      const Eigen::Quaterniond rotation(Eigen::AngleAxisd(angle_rad, axis));
      const std::size_t count = std::min(kRefiningViews, known_.samples().size());
      const std::vector<ObservedView> views = render(rotation, 0, count);
      std::vector<LandmarkPair> pairs;
      for (std::size_t k = 0; k < count; ++k)
        pair_landmarks(known_.landmarks(known_.samples()[k]),
                       landmarks_of(views[k], workshop_.studio.at), rotation, 0.1 * known_.radius(),
                       pairs);
      if (pairs.empty()) break;
      const Eigen::Vector3d better = Eigen::AngleAxisd(rotation_of(pairs)).axis();
      if (axis_angle_rad(axis, better) > 2 * kNearAxis_rad) break;
      axis = better.dot(axis) < 0 ? Eigen::Vector3d(-better) : better;
    }
    return axis;
  }

  bool is_cube_axis(const Eigen::Vector3d& axis) const {
    return std::any_of(cube_axes().begin(), cube_axes().end(),
                       [&](const Eigen::Vector3d& other) { return axis == other; });
  }

  bool try_any_angle(const Eigen::Vector3d& axis) {
    for (const double angle : kAnyAngles_rad)
      if (!is_likely(axis, angle)) return false;
    round_axis_ = is_cube_axis(axis) ? axis : refined(axis, kAnyAngles_rad[3]);
    return verify(Eigen::Quaterniond(Eigen::AngleAxisd(kAnyAngles_rad[0], round_axis_))) &&
           verify(Eigen::Quaterniond(Eigen::AngleAxisd(kAnyAngles_rad[3], round_axis_)));
  }

  void try_folds(const Eigen::Vector3d& axis) {
    for (const int fold : kFolds) {
      if (is_over()) return;
      if (group_.contains(turn_of(axis, fold))) return;
      if (!is_likely(axis, fold)) continue;
      const Eigen::Vector3d exact =
          is_cube_axis(axis) ? axis : refined(axis, 2 * std::numbers::pi / fold);
      if (group_.contains(turn_of(exact, fold))) return;
      if (verify(turn_of(exact, fold)) && group_.add(turn_of(exact, fold))) return;
    }
  }

  // Beside a round axis there can be a half turn across it; with any other angle it is a ball.
  void complete_round_object() {
    const Eigen::Vector3d across = round_axis_.unitOrthogonal();
    if (!verify(Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi, across)))) return;
    if (verify(Eigen::Quaterniond(Eigen::AngleAxisd(kAnyAngles_rad[1], across))))
      found_.axes = {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};
    else
      found_.rotations = {Eigen::Quaterniond(0, across.x(), across.y(), across.z())};
  }

  const Workshop& workshop_;
  KnownViews known_;
  tbb::enumerable_thread_specific<Observer> observers_;
  RotationGroup group_;
  Symmetries found_;
  Eigen::Vector3d round_axis_{0, 0, 1};
  std::size_t rendered_ = 0;
};

// Contours that are this small come and go with the pixel grid.
constexpr double kSpeck = 0.01;

bool are_equal(const ContourFeature& a, const ContourFeature& b) {
  constexpr float kShare = 0.03F, kPlace = 0.02F, kArea = 0.015F, kSecond = 0.005F, kThird = 0.005F;
  const auto near = [](float p, float q, float most) { return std::abs(p - q) <= most; };
  const auto near_moment = [&](float p, float q, float most) {
    return near(p * a.area, q * b.area, most);
  };
  for (std::size_t k = 0; k < 3; ++k)
    if (!near(a.share[k], b.share[k], kShare)) return false;
  const Moments &m = a.moments, &n = b.moments;
  return near(a.position.x, b.position.x, kPlace) && near(a.position.y, b.position.y, kPlace) &&
         near(a.area, b.area, kArea) && near_moment(m.xx, n.xx, kSecond) &&
         near_moment(m.xy, n.xy, kSecond) && near_moment(m.yy, n.yy, kSecond) &&
         near_moment(m.xxx, n.xxx, kThird) && near_moment(m.xxy, n.xxy, kThird) &&
         near_moment(m.xyy, n.xyy, kThird) && near_moment(m.yyy, n.yyy, kThird);
}

}  // namespace

bool are_equal_views(const ObservedView& a, const ObservedView& b) {
  if (std::abs(a.area_px - b.area_px) > 0.02F * std::max(a.area_px, b.area_px)) return false;
  std::vector<bool> used(b.external_count, false);
  for (std::size_t i = 0; i < a.external_count; ++i) {
    std::size_t k = 0;
    while (k < used.size() && (used[k] || !are_equal(a.contours[i].feature, b.contours[k].feature)))
      ++k;
    if (k < used.size())
      used[k] = true;
    else if (static_cast<double>(a.contours[i].feature.area) > kSpeck)
      return false;
  }
  for (std::size_t k = 0; k < used.size(); ++k)
    if (!used[k] && static_cast<double>(b.contours[k].feature.area) > kSpeck) return false;
  return true;
}

Symmetries find_symmetries(const Workshop& workshop, const Subdivision& subdivision) {
  return SymmetrySearch(workshop, subdivision).run();
}

}  // namespace aspect
