#include "tests/runtime/vision/range_scenes.h"

#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace aspect {
namespace {

constexpr double kStep = 1e-4;
constexpr double kFieldOfView_rad = 50 * std::numbers::pi / 180;

double dot(const Point3& a, const Point3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point3 sum(const Point3& a, double s, const Point3& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
Point3 unit(const Point3& a) {
  return sum({}, 1 / std::sqrt(dot(a, a)), a);
}

struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  int surface = 0;
};

// Surfaces get their numbers as they are named, planes by axis, side and place.
class Caster {
 public:
  explicit Caster(const Body& body) : body_(body) {}

  Hit cast(const Point3& from, const Point3& ray) {
    Hit hit;
    for (const SolidBox& box : body_.boxes) meet(box, from, ray, hit);
    for (std::size_t k = 0; k < body_.balls.size(); ++k) {
      const SolidBall& ball = body_.balls[k];
      const Point3 offset = sum(from, -1, ball.centre);
      const double a = dot(ray, ray), b = dot(offset, ray);
      const double root = b * b - a * (dot(offset, offset) - ball.radius * ball.radius);
      if (root >= 0) take((-b - std::sqrt(root)) / a, {6, static_cast<double>(k)}, hit);
    }
    for (std::size_t k = 0; k < body_.cylinders.size(); ++k) meet(k, from, ray, hit);
    return hit;
  }

 private:
  using Key = std::array<double, 2>;

  void take(double distance, const Key& key, Hit& hit) {
    if (distance <= 0 || distance >= hit.distance) return;
    hit = {distance,
           numbers_.try_emplace(key, static_cast<int>(numbers_.size()) + 1).first->second};
  }

  void meet(const SolidBox& box, const Point3& from, const Point3& ray, Hit& hit) {
    double enter = -std::numeric_limits<double>::infinity();
    double leave = std::numeric_limits<double>::infinity();
    Key key{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool forward = ray[axis] > 0;
      const double near = forward ? box.least[axis] : box.greatest[axis];
      const double far = forward ? box.greatest[axis] : box.least[axis];
      const double at = (near - from[axis]) / ray[axis];
      if (at > enter) {
        enter = at;
        key = {static_cast<double>(2 * axis + (forward ? 0 : 1)), near};
      }
      leave = std::min(leave, (far - from[axis]) / ray[axis]);
    }
    if (enter < leave) take(enter, key, hit);
  }

  void meet(std::size_t k, const Point3& from, const Point3& ray, Hit& hit) {
    const SolidCylinder& c = body_.cylinders[k];
    const double x = from[0] - c.x, y = from[1] - c.y;
    const double a = ray[0] * ray[0] + ray[1] * ray[1], b = x * ray[0] + y * ray[1];
    const double root = b * b - a * (x * x + y * y - c.radius * c.radius);
    if (root < 0) return;
    const double side = (-b - std::sqrt(root)) / a, z = from[2] + side * ray[2];
    if (z >= c.z_least && z <= c.z_greatest) take(side, {7, static_cast<double>(k)}, hit);
    for (const double end : {c.z_least, c.z_greatest}) {
      const double at = (end - from[2]) / ray[2];
      const double u = x + at * ray[0], v = y + at * ray[1];
      if (u * u + v * v <= c.radius * c.radius) take(at, {8, end}, hit);
    }
  }

  const Body& body_;
  std::map<Key, int> numbers_;
};

}  // namespace

Body cube_body() {
  return {{{{-0.2, -0.2, -0.2}, {0.2, 0.2, 0.2}}}, {}, {}};
}
Body l_body() {
  return {{{{-0.2, -0.15, -0.25}, {-0.05, 0.15, 0.25}}, {{-0.2, -0.15, -0.25}, {0.2, 0.15, -0.1}}},
          {},
          {}};
}
Body step_body() {
  return {
      {{{-0.25, -0.2, -0.1}, {0, 0.2, 0.05}}, {{-0.1, -0.2, -0.3}, {0.25, 0.2, -0.02}}}, {}, {}};
}
Body ball_body() {
  return {{}, {{{0, 0, 0}, 0.3}}, {}};
}
Body cylinder_body() {
  return {{}, {}, {{0, 0, 0.2, -0.25, 0.25}}};
}

RangeView range_view(const Body& body, const Point3& direction, double roll_rad, int side_px) {
  const Point3 from = unit(direction), forward = sum({}, -1, from);
  const Point3 other = std::abs(from[2]) < 0.9 ? Point3{0, 0, 1} : Point3{1, 0, 0};
  const Point3 level = unit(cross(forward, other)), plumb = cross(forward, level);
  const double c = std::cos(roll_rad), s = std::sin(roll_rad);
  const Point3 right = sum(sum({}, c, level), s, plumb), down = cross(forward, right);
  const double focal_px = side_px / 2.0 / std::tan(kFieldOfView_rad / 2);
  const double centre_px = (side_px - 1) / 2.0;
  Caster caster(body);
  RangeView view{cv::Mat::zeros(side_px, side_px, CV_16UC1),
                 cv::Mat::zeros(side_px, side_px, CV_8UC1)};
  for (int y = 0; y < side_px; ++y)
    for (int x = 0; x < side_px; ++x) {
      // With a ray of length 1 along the optical axis, distances along it are depths.
      const Point3 ray =
          sum(sum(forward, (x - centre_px) / focal_px, right), (y - centre_px) / focal_px, down);
      const Hit hit = caster.cast(from, ray);
      if (hit.surface == 0) continue;
      view.depth.at<std::uint16_t>(y, x) =
          static_cast<std::uint16_t>(std::lround(hit.distance / kStep));
      view.surface.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(hit.surface);
    }
  return view;
}

RangeView random_range_view(const Body& body, std::mt19937& random, int side_px) {
  std::normal_distribution<double> normal;
  const Point3 direction = {normal(random), normal(random), normal(random)};
  return range_view(body, direction, normal(random), side_px);
}

void add_depth_noise(cv::Mat& depth, std::mt19937& random, int most) {
  std::uniform_int_distribution<int> noise(-most, most);
  for (int y = 0; y < depth.rows; ++y)
    for (int x = 0; x < depth.cols; ++x)
      if (auto& steps = depth.at<std::uint16_t>(y, x); steps != 0)
        steps = static_cast<std::uint16_t>(steps + noise(random));
}

Frame depth_frame(const cv::Mat& depth) {
  return {depth.data, depth.cols, depth.rows, static_cast<std::ptrdiff_t>(depth.step),
          PixelFormat::depth16};
}

}  // namespace aspect
