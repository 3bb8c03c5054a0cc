#include "runtime/recognition/view_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/base/portable_math.h"
#include "runtime/recognition/light_estimate.h"

namespace aspect {
namespace {

// Key views of a class that are followed where they are seen from elsewhere and fit about as well.
constexpr std::size_t kMostViews = 3;
constexpr float kNear_cos = 0.94F;  // 20 degrees

// The compiler puts the key views of a class so that each is as far as can be from those before it.
// The first third shows where the rest is worth a look: costs change slowly with the view.
constexpr std::size_t kCoarseShare = 3, kFewestCoarse = 4;
constexpr float kWorthFactor = 4, kWorthLeast = 8;

// A fit that costs this much is not worth to be worked out where another one costs `least`.
float give_up(float least) {
  constexpr float kFactor = 4, kLeast = 8;
  return std::max(kLeast, kFactor * least);
}

float cos_between(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

void ViewSearch::Fitted::add(const KeyView& view, float cost) {
  if (count == kMostFitted) return;
  views[count] = &view;
  costs[count++] = cost;
}

float ViewSearch::Fitted::cost_nearest(const KeyView& view, std::size_t among) const {
  float most = -2, cost = 0;
  for (std::size_t k = 0; k < among; ++k) {
    const float near = cos_between(views[k]->direction, view.direction);
    if (near <= most) continue;
    most = near;
    cost = costs[k];
  }
  return cost;
}

// The view found is the mean of the key views that fit about as well as the best one of their
// class and look from near it.
Vector3 ViewSearch::Fitted::mean_about(const KeyView& best, float best_cost) const {
  Vector3 sum{};
  const float scale = 1.0F + 0.5F * best_cost;
  for (std::size_t k = 0; k < count; ++k) {
    const Vector3& direction = views[k]->direction;
    if (cos_between(best.direction, direction) < kNear_cos) continue;
    const float weight =
        static_cast<float>(portable_exp(static_cast<double>((best_cost - costs[k]) / scale)));
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += weight * direction[axis];
  }
  const float length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
  if (!(length > 0)) return best.direction;
  return {sum[0] / length, sum[1] / length, sum[2] / length};
}

// The best of those seen from elsewhere than all of `taken`, null: none.
const KeyView* ViewSearch::Fitted::elsewhere(std::span<const KeyView* const> taken,
                                             float most_cost) const {
  const KeyView* best = nullptr;
  for (std::size_t k = 0; k < count; ++k) {
    const auto is_near = [&](const KeyView* other) {
      return cos_between(other->direction, views[k]->direction) >= kNear_cos;
    };
    if (costs[k] > most_cost || std::any_of(taken.begin(), taken.end(), is_near)) continue;
    best = views[k];
    most_cost = costs[k];
  }
  return best;
}

ViewSearch::Best ViewSearch::fit_class(const ClassIndex& index, const AspectClass& aspect,
                                       float least_cost) {
  fitted_.count = 0;
  Best best;
  best.fit.cost = std::numeric_limits<float>::infinity();
  const auto views = ClassIndex::part(index.key_views, aspect.key_views);
  const std::size_t coarse =
      std::min(views.size(), std::max(kFewestCoarse, views.size() / kCoarseShare));
  for (std::size_t k = 0; k < views.size(); ++k) {
    const KeyView& view = views[k];
    const float least = std::min(least_cost, best.fit.cost);
    if (k >= coarse &&
        fitted_.cost_nearest(view, coarse) > std::max(kWorthLeast, kWorthFactor * least))
      continue;
    const ViewFit fit =
        fitter_.fit(ClassIndex::part(index.key_contours, view.contours), give_up(least));
    fitted_.add(view, fit.cost);
    if (fit.cost >= best.fit.cost) continue;
    best = {fit, &view};
  }
  return best;
}

// The best view is found to a few degrees, so that a class seen from near it may be the right one
// however badly its own key views fit, as they do at its border.
void ViewSearch::raise_neighbours(std::span<Hypothesis> list) const {
  constexpr double kShare = 0.5, kReach_rad = 0.05;
  if (list.empty()) return;
  const Hypothesis best = *std::min_element(list.begin(), list.end(), better);
  const ClassIndex& index = indexes_[best.index];
  for (Hypothesis& hypothesis : list) {
    if (hypothesis.index != best.index) continue;
    float nearest = -1;
    const AspectClass& aspect = index.classes[hypothesis.class_id];
    for (const KeyView& view : ClassIndex::part(index.key_views, aspect.key_views))
      nearest = std::max(nearest, cos_between(view.direction, best.view));
    const double angle = portable_acos(std::clamp(static_cast<double>(nearest), -1.0, 1.0));
    hypothesis.score =
        std::max(hypothesis.score, kShare * best.score * portable_exp(-angle / kReach_rad));
  }
}

std::size_t ViewSearch::run(std::span<const ContourFeature> seen, std::span<Hypothesis> room,
                            std::size_t count, const Deadline& deadline) {
  fitter_.set_contours(seen);
  float least_cost = std::numeric_limits<float>::infinity();
  const auto is_fitted = [&](const Hypothesis& h) { return h.least_cost < give_up(least_cost); };
  std::size_t fitted = 0, end = count;
  for (; fitted < count && is_fitted(room[fitted]); ++fitted) {
    Hypothesis& hypothesis = room[fitted];
    if (deadline.is_over()) {
      hypothesis.score = 0;
      continue;
    }
    const ClassIndex& index = indexes_[hypothesis.index];
    const Best best = fit_class(index, index.classes[hypothesis.class_id], least_cost);
    if (best.view == nullptr) {
      hypothesis.score = 0;
      continue;
    }
    least_cost = std::min(least_cost, best.fit.cost);
    const auto start_from = [&](Hypothesis& h, const KeyView& view, const ViewFit& fit) {
      h.score = 1 / (1 + static_cast<double>(fit.cost));
      h.view = fitted_.mean_about(view, fit.cost);
      h.roll_rad = fit.roll_rad;
      h.start = {view.direction, h.view, fit.roll_rad,
                 estimate_light(seen, ClassIndex::part(index.key_contours, view.contours),
                                fit.assignment)};
    };
    start_from(hypothesis, *best.view, best.fit);
    constexpr float kAsWell = 1.5F, kSlack = 0.5F;
    const float most_cost = kAsWell * best.fit.cost + kSlack;
    std::array<const KeyView*, kMostViews> taken{best.view};
    for (std::size_t k = 1; k < kMostViews && end < room.size(); ++k) {
      taken[k] = fitted_.elsewhere(std::span(taken).first(k), most_cost);
      if (taken[k] == nullptr) break;
      Hypothesis& second = room[end++];
      second = hypothesis;
      second.is_second_view = true;
      start_from(
          second, *taken[k],
          fitter_.fit(ClassIndex::part(index.key_contours, taken[k]->contours), 2 * most_cost));
    }
  }
  // What is too unlikely to be fitted makes room for the second views.
  const auto seconds = room.subspan(count, end - count);
  std::move(seconds.begin(), seconds.end(), room.begin() + static_cast<std::ptrdiff_t>(fitted));
  const std::size_t all = fitted + seconds.size();
  raise_neighbours(room.first(all));
  return all;
}

}  // namespace aspect
