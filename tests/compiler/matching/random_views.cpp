#include "tests/compiler/matching/random_views.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace aspect {
namespace {

double between(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

float number(std::mt19937& random, double low, double high) {
  return static_cast<float>(between(random, low, high));
}

ContourFeature random_feature(std::mt19937& random) {
  constexpr std::array<std::array<float, 3>, 3> kColours = {
      {{0.5F, 0.3F, 0.2F}, {0.52F, 0.29F, 0.19F}, {0.2F, 0.3F, 0.5F}}};
  ContourFeature feature;
  feature.share = kColours[random() % kColours.size()];
  feature.area = number(random, 0.05, 0.4);
  feature.position = {number(random, -0.6, 0.6), number(random, -0.6, 0.6)};
  feature.moments.xx = number(random, 0.05, 0.4);
  feature.moments.xy = number(random, -0.1, 0.1);
  feature.moments.yy = number(random, 0.05, 0.4);
  return feature;
}

std::uint8_t code_between(const ContourFeature& from, const ContourFeature& to) {
  const double x = static_cast<double>(to.position.x) - static_cast<double>(from.position.x);
  const double y = static_cast<double>(to.position.y) - static_cast<double>(from.position.y);
  return static_cast<std::uint8_t>(std::lround(std::atan2(y, x) * 8 / std::numbers::pi) & 15);
}

void relate_all(std::mt19937& random, ObservedView& view) {
  view.relations.clear();
  for (std::size_t i = 0; i < view.external_count; ++i) {
    for (std::size_t k = 0; k < view.external_count; ++k) {
      if (i == k) continue;
      Relation relation;
      relation.from = static_cast<std::uint16_t>(i);
      relation.to = static_cast<std::uint16_t>(k);
      relation.direction = code_between(view.contours[i].feature, view.contours[k].feature);
      relation.kind =
          random() % 8 == 0 ? static_cast<Relation::Kind>(random() % 4) : Relation::Kind::apart;
      view.relations.push_back(relation);
    }
  }
}

Eigen::Vector3d any_right(std::mt19937& random, const Eigen::Vector3d& direction) {
  for (;;) {
    const Eigen::Vector3d right = direction.cross(random_unit_vector(random));
    if (right.norm() > 0.1) return right.normalized();
  }
}

void move(float& attribute, std::mt19937& random, double noise) {
  attribute += noise > 0 ? number(random, -noise, noise) : 0.0F;
}

}  // namespace

Eigen::Vector3d random_unit_vector(std::mt19937& random) {
  for (;;) {
    const Eigen::Vector3d v(between(random, -1, 1), between(random, -1, 1), between(random, -1, 1));
    if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
  }
}

ObservedView random_view(std::mt19937& random, std::size_t count) {
  ObservedView view;
  view.direction = random_unit_vector(random);
  view.right = any_right(random, view.direction);
  view.external_count = count;
  for (std::size_t k = 0; k < count; ++k) {
    ObservedContour contour;
    // A third of the contours look like the one before, but for their place.
    contour.feature = random_feature(random);
    if (k > 0 && random() % 3 == 0) {
      const Point2 place = contour.feature.position;
      contour.feature = view.contours.back().feature;
      contour.feature.position = place;
    }
    view.contours.push_back(contour);
  }
  relate_all(random, view);
  return view;
}

ObservedView shuffled_view(std::mt19937& random, const ObservedView& view, double noise) {
  ObservedView other =
      carried_view(view, (view.direction + 0.3 * random_unit_vector(random)).normalized());
  if (random() % 2 == 0) other.right = any_right(random, other.direction);
  std::shuffle(other.contours.begin(), other.contours.end(), random);
  for (ObservedContour& contour : other.contours) {
    ContourFeature& f = contour.feature;
    for (float& share : f.share) move(share, random, noise);
    for (float* attribute :
         {&f.area, &f.position.x, &f.position.y, &f.moments.xx, &f.moments.xy, &f.moments.yy})
      move(*attribute, random, noise);
  }
  relate_all(random, other);
  return other;
}

ObservedView rolled_view(const ObservedView& view, double angle_rad) {
  ObservedView rolled = view;
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  const Eigen::Vector3d down = (-view.direction).cross(view.right);
  rolled.right = c * view.right - s * down;
  for (ObservedContour& contour : rolled.contours) {
    ContourFeature& f = contour.feature;
    const double x = static_cast<double>(f.position.x), y = static_cast<double>(f.position.y);
    f.position = {static_cast<float>(c * x - s * y), static_cast<float>(s * x + c * y)};
    Eigen::Matrix2d turn, spread;
    turn << c, -s, s, c;
    const Moments& m = f.moments;
    spread << static_cast<double>(m.xx), static_cast<double>(m.xy), static_cast<double>(m.xy),
        static_cast<double>(m.yy);
    const Eigen::Matrix2d turned_spread = turn * spread * turn.transpose();
    f.moments.xx = static_cast<float>(turned_spread(0, 0));
    f.moments.xy = static_cast<float>(turned_spread(0, 1));
    f.moments.yy = static_cast<float>(turned_spread(1, 1));
  }
  for (Relation& relation : rolled.relations)
    relation.direction =
        code_between(rolled.contours[relation.from].feature, rolled.contours[relation.to].feature);
  return rolled;
}

ObservedView carried_view(const ObservedView& view, const Eigen::Vector3d& direction) {
  ObservedView carried = view;
  const double angle = std::acos(std::clamp(view.direction.dot(direction), -1.0, 1.0));
  const Eigen::Vector3d axis = view.direction.cross(direction).normalized();
  carried.direction = direction;
  carried.right = Eigen::AngleAxisd(angle, axis) * view.right;
  return carried;
}

}  // namespace aspect
