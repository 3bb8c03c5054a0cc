// The drawing against rays through every cell, and borders against what a drawing shows.
#include "runtime/recognition/model_drawing.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <random>

#include "runtime/base/planned_memory.h"
#include "runtime/recognition/model_borders.h"
#include "tests/runtime/recognition/painted_box.h"

namespace aspect {
namespace {

const CameraModel kCamera{500, 510, 320, 240, 0, 0, 0, 0, 0};

ObjectModel box_model() {
  return prepared_model(painted_box(1, 0.6, 0.4), 3, 60);
}

struct Seen {
  ColourClass colour = kBackgroundClass;
  double depth = 1e9;
};

Seen seen_along(const ObjectModel& model, const RigidPose& pose, double x_px, double y_px) {
  const Eigen::Vector3d ray((x_px - kCamera.cx_px) / kCamera.fx_px,
                            (y_px - kCamera.cy_px) / kCamera.fy_px, 1);
  Seen nearest;
  for (const ModelTriangle& triangle : model.triangles) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) {
      const Vector3d p = pose(model.vertices[triangle.corners[static_cast<std::size_t>(k)]]);
      corners.col(k) = Eigen::Vector3d(p[0], p[1], p[2]);
    }
    const Eigen::Vector3d shares = corners.fullPivLu().solve(ray);
    if (shares.minCoeff() < 0) continue;
    const double depth = 1 / shares.sum();
    if (depth < nearest.depth) nearest = {triangle.colour, depth};
  }
  return nearest;
}

RigidPose random_pose(std::mt19937& random) {
  std::normal_distribution<double> number;
  const Vector3d axis{number(random), number(random), number(random)};
  std::uniform_real_distribution<double> angle(0, 3.1), shift(-0.5, 0.5);
  return {turn_about((1 / norm(axis)) * axis, angle(random)),
          {shift(random), shift(random), 6 + shift(random)}};
}

struct Drawer {
  explicit Drawer(std::size_t vertices) {
    memory.plan([&](Arena& arena) { drawing.prepare(arena, vertices); });
  }
  PlannedMemory memory;
  ModelDrawing drawing;
};

}  // namespace

TEST_CASE("A drawing shows in each cell what a ray through its centre meets first") {
  const ObjectModel model = box_model();
  REQUIRE(model.shares.size() == 6);
  Drawer drawer(model.vertices.size());
  std::mt19937 random(6);
  for (int round = 0; round < 30; ++round) {
    const RigidPose pose = random_pose(random);
    REQUIRE(drawer.drawing.draw(model, pose, kCamera, {220, 140, 200, 200}));
    int cells = 0, wrong = 0;
    for (int row = 0; row < drawer.drawing.height(); ++row)
      for (int column = 0; column < drawer.drawing.width(); ++column) {
        const Seen seen = seen_along(model, pose, static_cast<double>(drawer.drawing.x_px(column)),
                                     static_cast<double>(drawer.drawing.y_px(row)));
        const ModelDrawing::Cell cell = drawer.drawing.cell(column, row);
        ++cells;
        if (cell.colour != seen.colour) ++wrong;
        if (cell.covered && cell.colour == seen.colour)
          CHECK(static_cast<double>(cell.nearness) * seen.depth == Approx(1).epsilon(1e-3));
      }
    // Rounding may give a cell on an edge to either side.
    CHECK(wrong * 500 <= cells);
  }
}

TEST_CASE("An object behind the camera or around it is not drawn") {
  const ObjectModel model = box_model();
  Drawer drawer(model.vertices.size());
  CHECK_FALSE(drawer.drawing.draw(model, {{}, {0, 0, -5}}, kCamera, {0, 0, 10, 10}));
  CHECK_FALSE(drawer.drawing.draw(model, {{}, {0, 0, 0}}, kCamera, {0, 0, 10, 10}));
}

TEST_CASE("Border points lie on borders of what is seen, with the colours of their sides") {
  const ObjectModel model = box_model();
  Drawer drawer(model.vertices.size());
  std::mt19937 random(7);
  for (int round = 0; round < 30; ++round) {
    const RigidPose pose = random_pose(random);
    REQUIRE(drawer.drawing.draw(model, pose, kCamera, {220, 140, 200, 200}));
    std::array<BorderPoint, kMaxBorderPoints> points;
    const std::size_t count = find_border_points(model, drawer.drawing, points);
    CHECK(count > 20);
    int right = 0;
    for (const BorderPoint& p : std::span(points).first(count)) {
      constexpr float kStep_px = 2.5F;
      const auto colour = [&](float step) {
        return seen_along(model, pose, static_cast<double>(p.x_px + step * p.normal_x),
                          static_cast<double>(p.y_px + step * p.normal_y))
            .colour;
      };
      right += colour(-kStep_px) == p.inside && colour(kStep_px) == p.outside ? 1 : 0;
      const Vector3d q = pose(p.point_object);
      CHECK(kCamera.cx_px + kCamera.fx_px * q[0] / q[2] ==
            Approx(static_cast<double>(p.x_px)).margin(0.01));
      CHECK(kCamera.cy_px + kCamera.fy_px * q[1] / q[2] ==
            Approx(static_cast<double>(p.y_px)).margin(0.01));
    }
    // Near corners a step along the normal may leave a thin face.
    CHECK(right * 100 >= static_cast<int>(count) * 95);
  }
}

}  // namespace aspect
