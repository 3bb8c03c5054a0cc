// Steps: compare what does not change with roll, which gives a lower bound and rules out most
// pairs; guess the roll from where two anchors, the contours with the longest levers, would have
// to go, from the main axis where there is no lever, and from none at all; at every guess match
// the contours exactly and add up what differs; improve the best guess once by the least-squares
// roll of its matches. Weak side: contours whose blob is cut by the picture's border or by another
// object have other sizes and places.
#include "runtime/recognition/view_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "runtime/base/portable_math.h"

namespace aspect {
namespace {

float square(float x) {
  return x * x;
}

float radius(Point2 p) {
  return portable_hypot(p.x, p.y);
}

float angle_rad(float up, float across) {
  return static_cast<float>(portable_atan2(static_cast<double>(up), static_cast<double>(across)));
}

// In units of the blob instead of the contour.
Moments in_blob(const Moments& m, float area) {
  const float third = area * std::sqrt(area);
  return {m.xx * area,   m.xy * area,   m.yy * area,  m.xxx * third,
          m.xxy * third, m.xyy * third, m.yyy * third};
}

// Direction of the main axis of a second moment.
float axis_rad(const Moments& m) {
  return angle_rad(2 * m.xy, m.xx - m.yy) / 2;
}

}  // namespace

void ViewFitter::set_contours(std::span<const ContourFeature> seen) {
  seen_ = seen.first(std::min(seen.size(), kMaxSide));
  constexpr float kLeastLever = 0.08F;
  anchor_count_ = 0;
  float best = 0, second = 0;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const float area = seen_[i].area, distance = radius(seen_[i].position);
    of_seen_[i] = {scales_.alone(area), distance, in_blob(seen_[i].moments, area)};
    const float lever = distance * std::sqrt(seen_[i].area);
    if (distance < kLeastLever || lever <= second) continue;
    if (lever > best) {
      anchors_[1] = anchors_[0];
      second = best;
      anchors_[0] = i;
      best = lever;
    } else {
      anchors_[1] = i;
      second = lever;
    }
    anchor_count_ = second > 0 ? 2 : 1;
  }
}

// Fills roll_free_ and adds up the least that every seen contour must cost.
float ViewFitter::least_cost(std::span<const KeyContour> key) {
  std::array<float, kMaxSide> least;
  for (std::size_t i = 0; i < seen_.size(); ++i) least[i] = of_seen_[i].alone;
  for (std::size_t k = 0; k < key.size(); ++k) {
    const ContourFeature& b = key[k].feature;
    const float b_radius = radius(b.position);
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      const ContourFeature& a = seen_[i];
      const float distance = square((of_seen_[i].radius - b_radius) / scales_.position);
      const float cost = (square(a.share[0] - b.share[0]) + square(a.share[1] - b.share[1]) +
                          square(a.share[2] - b.share[2])) /
                             square(scales_.share) +
                         square((a.area - b.area) / scales_.area) + distance;
      roll_free_[i * key.size() + k] = cost;
      placeless_[i * key.size() + k] = cost - distance;
      least[i] = std::min(least[i], cost);
    }
  }
  float total = 0;
  for (std::size_t i = 0; i < seen_.size(); ++i) total += least[i];
  return total;
}

std::size_t ViewFitter::candidate_turns(std::span<const KeyContour> key) {
  std::size_t count = 0;
  turns_[count++] = {};
  constexpr float kLeastLever = 0.05F;
  for (std::size_t n = 0; n < anchor_count_; ++n) {
    const std::size_t i = anchors_[n];
    const Point2 a = seen_[i].position;
    for (std::size_t k = 0; k < key.size() && count + 4 < kMaxTurns; ++k) {
      const Point2 b = key[k].feature.position;
      const float length = radius(a) * radius(b);
      if (radius(b) < kLeastLever || roll_free_[i * key.size() + k] > of_seen_[i].alone) continue;
      turns_[count++] = {(a.x * b.x + a.y * b.y) / length, (a.y * b.x - a.x * b.y) / length};
    }
  }
  if (count > 1 || seen_.empty() || key.empty()) return count;
  const auto larger = [](const auto& p, const auto& q) { return p.area < q.area; };
  const ContourFeature& a = *std::max_element(seen_.begin(), seen_.end(), larger);
  const ContourFeature& b =
      std::max_element(key.begin(), key.end(), [&](const KeyContour& p, const KeyContour& q) {
        return larger(p.feature, q.feature);
      })->feature;
  const auto angle = static_cast<double>(axis_rad(a.moments) - axis_rad(b.moments));
  const float c = static_cast<float>(portable_cos(angle)),
              s = static_cast<float>(portable_sin(angle));
  for (const Turn& turn : {Turn{c, s}, Turn{-s, c}, Turn{-c, -s}, Turn{s, -c}})
    turns_[count++] = turn;
  return count;
}

// On top of `cost`, what two shapes differ by.
float ViewFitter::add_shape(float cost, const Moments& a, const Moments& b) const {
  cost += (square(a.xx - b.xx) + 2 * square(a.xy - b.xy) + square(a.yy - b.yy)) /
          square(scales_.second);
  cost += (square(a.xxx - b.xxx) + 3 * square(a.xxy - b.xxy) + 3 * square(a.xyy - b.xyy) +
           square(a.yyy - b.yyy)) /
          square(scales_.third);
  return cost;
}

// No assignment weighs more: every seen contour has its best partner.
double ViewFitter::most_weight(std::size_t columns) const {
  double total = 0;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    double best = 0;
    for (std::size_t k = 0; k < columns; ++k) best = std::max(best, weights_[i * columns + k]);
    total += best;
  }
  return total;
}

// The cost, or something of at least `give_up` that it is not below.
float ViewFitter::evaluate(std::span<const KeyContour> key, Turn turn, float give_up,
                           Assignment& assignment) {
  const Turning turning(turn.cos, turn.sin);
  float total = scales_.roll * (1 - turn.cos) / 2;
  for (std::size_t i = 0; i < seen_.size(); ++i) total += of_seen_[i].alone;
  for (std::size_t k = 0; k < key.size(); ++k) {
    const ContourFeature& b = key[k].feature;
    const float key_alone = scales_.alone(b.area);
    total += key_alone;
    const Point2 place = turning(b.position);
    std::optional<Moments> shape;  // most have no partner that it must be known for
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      const float most = of_seen_[i].alone + key_alone;
      double& weight = weights_[i * key.size() + k];
      weight = 0;
      float cost = placeless_[i * key.size() + k];
      if (cost >= most) continue;
      const Point2 a = seen_[i].position;
      cost += (square(a.x - place.x) + square(a.y - place.y)) / square(scales_.position);
      if (cost >= most) continue;
      if (!shape) shape = in_blob(turning(b.moments), b.area);
      weight = static_cast<double>(most - add_shape(cost, of_seen_[i].shape, *shape));
    }
  }
  // Sums differ in their last digits by the order that they are made in.
  constexpr double kRounding = 1 + 1e-9;
  const float bound = total - static_cast<float>(most_weight(key.size()) * kRounding);
  if (bound >= give_up) return bound;
  assign(weights_, seen_.size(), key.size(), assignment);
  return total - static_cast<float>(assignment.weight);
}

ViewFitter::Turn ViewFitter::aligned(std::span<const KeyContour> key, const Assignment& assignment,
                                     Turn otherwise) const {
  float along = 0, across = 0;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    if (assignment.column_of[i] < 0) continue;
    const ContourFeature& b = key[static_cast<std::size_t>(assignment.column_of[i])].feature;
    const Point2 p = seen_[i].position, q = b.position;
    along += b.area * (p.x * q.x + p.y * q.y);
    across += b.area * (p.y * q.x - p.x * q.y);
  }
  const float length = portable_hypot(along, across);
  constexpr float kLeast = 1e-3F;
  return length < kLeast ? otherwise : Turn{along / length, across / length};
}

ViewFit ViewFitter::fit(std::span<const KeyContour> key, float give_up) {
  ViewFit best;
  best.cost = least_cost(key);
  if (best.cost >= give_up) return best;
  best.cost = std::numeric_limits<float>::infinity();
  Turn best_turn;
  Assignment assignment;
  const auto attempt = [&](Turn turn) {
    const float cost = evaluate(key, turn, best.cost, assignment);
    if (cost >= best.cost) return;
    best.cost = cost;
    best.assignment = assignment;
    best_turn = turn;
  };
  const std::size_t turns = candidate_turns(key);
  for (std::size_t t = 0; t < turns; ++t) attempt(turns_[t]);
  attempt(aligned(key, best.assignment, best_turn));
  best.roll_rad = angle_rad(best_turn.sin, best_turn.cos);
  return best;
}

}  // namespace aspect
