// Drawn larger than asked, triangle by triangle with the nearest one kept for each pixel; edges are
// where neighbouring pixels show different things; then made smaller, so that borders are smooth.
#include "tools/draw/model_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "tools/draw/paper.h"

namespace aspect {
namespace {

constexpr int kFiner = 3;
constexpr double kBend = 0.906;  // cosine of 25 degrees
constexpr double kStep = 0.02;   // of the model's radius: one surface before another
const cv::Vec3b kLine(52, 46, 42);

struct Canvas {
  int side = 0;
  std::vector<int> triangle;     // by pixel, -1: none
  std::vector<double> nearness;  // 1 / depth

  explicit Canvas(int side_px)
      : side(side_px),
        triangle(static_cast<std::size_t>(side_px) * static_cast<std::size_t>(side_px), -1),
        nearness(triangle.size(), 0) {}
  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side) +
           static_cast<std::size_t>(x);
  }
};

// The model before the camera, its radius 1.
struct Posed {
  std::vector<Vector3d> points;   // camera coordinates
  std::vector<Vector3d> normals;  // by triangle, towards the camera
  double focal_px = 0, middle_px = 0;

  cv::Point2d screen(const Vector3d& p) const {
    return {middle_px + focal_px * p[0] / p[2], middle_px + focal_px * p[1] / p[2]};
  }
  Vector3d at(int x, int y, double nearness) const {
    return {(x - middle_px) / focal_px / nearness, (y - middle_px) / focal_px / nearness,
            1 / nearness};
  }
};

// Of a ball that holds all, about what the views look at; about the vertices' middle where that is
// far away, as in an index that someone made up.
std::pair<Vector3d, double> ball_of(const ObjectModel& model) {
  Vector3d least = model.vertices.front(), most = least;
  for (const Vector3d& v : model.vertices)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      least[axis] = std::min(least[axis], v[axis]);
      most[axis] = std::max(most[axis], v[axis]);
    }
  const Vector3d middle = least + 0.5 * (most - least);
  const double half = norm(0.5 * (most - least));
  const double off = norm(model.centre - middle);
  const Vector3d centre = off <= half ? model.centre : middle;
  double radius = 0;
  for (const Vector3d& v : model.vertices) radius = std::max(radius, norm(v - centre));
  return {centre, radius};
}

Posed posed(const ObjectModel& model, const Vector3d& direction, double field_of_view_deg,
            int side_px) {
  const auto [centre, radius] = ball_of(model);
  const double field = std::isfinite(field_of_view_deg) ? field_of_view_deg : 45;
  const double half_rad = std::clamp(field, 5.0, 120.0) / 2 * std::numbers::pi / 180;
  const auto rows = camera_from_object(direction, model.up).rows();
  const double distance = 1.04 / std::sin(half_rad);
  Posed out;
  out.middle_px = (side_px - 1) / 2.0;
  out.focal_px = side_px / 2.0 / std::tan(half_rad);
  for (const Vector3d& v : model.vertices) {
    const Vector3d p = (1 / radius) * (v - centre);
    out.points.push_back({dot(rows[0], p), dot(rows[1], p), dot(rows[2], p) + distance});
  }
  for (const ModelTriangle& t : model.triangles) {
    const Vector3d& a = out.points[t.corners[0]];
    Vector3d normal = cross(out.points[t.corners[1]] - a, out.points[t.corners[2]] - a);
    const double length = norm(normal);
    if (length > 0) normal = (dot(normal, a) > 0 ? -1 / length : 1 / length) * normal;
    out.normals.push_back(normal);
  }
  return out;
}

void fill(Canvas& canvas, const Posed& posed, const ModelTriangle& triangle, int number) {
  const Vector3d &p = posed.points[triangle.corners[0]], &q = posed.points[triangle.corners[1]],
                 &r = posed.points[triangle.corners[2]];
  const cv::Point2d a = posed.screen(p), b = posed.screen(q), c = posed.screen(r);
  const double area = (b - a).cross(c - a);
  if (!(std::abs(area) > 1e-9)) return;
  const auto within = [&](double pixel) {
    return static_cast<int>(std::clamp(pixel, -1.0, static_cast<double>(canvas.side)));
  };
  const int left = std::max(0, within(std::ceil(std::min({a.x, b.x, c.x})))),
            top = std::max(0, within(std::ceil(std::min({a.y, b.y, c.y})))),
            right = std::min(canvas.side - 1, within(std::floor(std::max({a.x, b.x, c.x})))),
            bottom = std::min(canvas.side - 1, within(std::floor(std::max({a.y, b.y, c.y}))));
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) {
      const cv::Point2d d(x - a.x, y - a.y);
      const double u = d.cross(c - a) / area, v = (b - a).cross(d) / area;
      if (u < 0 || v < 0 || u + v > 1) continue;
      const double nearness = 1 / p[2] + u * (1 / q[2] - 1 / p[2]) + v * (1 / r[2] - 1 / p[2]);
      const std::size_t place = canvas.place(x, y);
      if (nearness <= canvas.nearness[place]) continue;
      canvas.nearness[place] = nearness;
      canvas.triangle[place] = number;
    }
}

bool is_edge(const Canvas& canvas, const Posed& posed, const ObjectModel& model, cv::Point at,
             cv::Point next) {
  const std::size_t a = canvas.place(at.x, at.y), b = canvas.place(next.x, next.y);
  const int first = canvas.triangle[a], second = canvas.triangle[b];
  if (first == second) return false;
  if (first < 0 || second < 0) return true;
  const auto i = static_cast<std::size_t>(first), k = static_cast<std::size_t>(second);
  if (model.triangles[i].paint != model.triangles[k].paint) return true;
  if (dot(posed.normals[i], posed.normals[k]) < kBend) return true;
  const Vector3d gap =
      posed.at(next.x, next.y, canvas.nearness[b]) - posed.at(at.x, at.y, canvas.nearness[a]);
  return std::min(std::abs(dot(posed.normals[i], gap)), std::abs(dot(posed.normals[k], gap))) >
         kStep;
}

// On both sides of a border, which makes it as wide as two fine pixels.
cv::Mat edges_of(const Canvas& canvas, const Posed& posed, const ObjectModel& model) {
  cv::Mat edges = cv::Mat::zeros(canvas.side, canvas.side, CV_8UC1);
  for (int y = 0; y + 1 < canvas.side; ++y)
    for (int x = 0; x + 1 < canvas.side; ++x)
      for (const cv::Point next : {cv::Point(x + 1, y), cv::Point(x, y + 1)})
        if (is_edge(canvas, posed, model, {x, y}, next))
          edges.at<std::uint8_t>(y, x) = edges.at<std::uint8_t>(next) = 255;
  return edges;
}

cv::Vec3b colour_of(const ObjectModel& model, int triangle) {
  if (triangle < 0)
    return {static_cast<std::uint8_t>(kPaper[0]), static_cast<std::uint8_t>(kPaper[1]),
            static_cast<std::uint8_t>(kPaper[2])};
  const auto& paint = model.paints[model.triangles[static_cast<std::size_t>(triangle)].paint];
  return {paint[2], paint[1], paint[0]};
}

}  // namespace

ModelPicture model_picture(const ObjectModel& model, const Vector3d& direction_unit,
                           double field_of_view_deg, int side_px) {
  ModelPicture drawn{cv::Mat(side_px, side_px, CV_8UC3, kPaper),
                     cv::Mat::zeros(side_px, side_px, CV_8UC1)};
  if (model.empty()) return drawn;
  Canvas canvas(kFiner * side_px);
  const Posed before = posed(model, direction_unit, field_of_view_deg, canvas.side);
  for (std::size_t k = 0; k < model.triangles.size(); ++k)
    fill(canvas, before, model.triangles[k], static_cast<int>(k));
  const cv::Mat edges = edges_of(canvas, before, model);
  cv::Mat fine(canvas.side, canvas.side, CV_8UC3), covered(canvas.side, canvas.side, CV_8UC1);
  for (int y = 0; y < canvas.side; ++y)
    for (int x = 0; x < canvas.side; ++x) {
      const int triangle = canvas.triangle[canvas.place(x, y)];
      const bool is_line = edges.at<std::uint8_t>(y, x) != 0;
      fine.at<cv::Vec3b>(y, x) = is_line ? kLine : colour_of(model, triangle);
      covered.at<std::uint8_t>(y, x) = triangle < 0 ? 0 : 255;
    }
  cv::resize(fine, drawn.picture, drawn.picture.size(), 0, 0, cv::INTER_AREA);
  cv::resize(covered, drawn.covered, drawn.covered.size(), 0, 0, cv::INTER_AREA);
  return drawn;
}

}  // namespace aspect
