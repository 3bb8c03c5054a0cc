// Range frames of bodies whose surfaces are known by formula, cast ray by ray.
#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <random>
#include <vector>

#include "runtime/vision/frame.h"

namespace aspect {

using Point3 = std::array<double, 3>;

struct SolidBox {
  Point3 least, greatest;
};
struct SolidBall {
  Point3 centre;
  double radius;
};
// Along z, closed by two discs.
struct SolidCylinder {
  double x, y, radius, z_least, z_greatest;
};

// A body is a union; faces of its boxes that lie in one plane are one surface.
struct Body {
  std::vector<SolidBox> boxes;
  std::vector<SolidBall> balls;
  std::vector<SolidCylinder> cylinders;
};

Body cube_body();
Body l_body();     // two boxes, three of whose faces are common
Body step_body();  // two parallel faces, one behind the other, as seen along -z
Body ball_body();
Body cylinder_body();

// Seen from distance 1 under 50 degrees.
struct RangeView {
  cv::Mat depth;    // CV_16UC1, in steps of 0.0001; 0: nothing
  cv::Mat surface;  // CV_8UC1: the surface that is seen, from 1
};

// The camera looks at the origin from `direction`, turned by `roll_rad`.
RangeView range_view(const Body& body, const Point3& direction, double roll_rad, int side_px);
RangeView random_range_view(const Body& body, std::mt19937& random, int side_px);

// Every depth that was measured moved by up to `most` steps.
void add_depth_noise(cv::Mat& depth, std::mt19937& random, int most);

Frame depth_frame(const cv::Mat& depth);

}  // namespace aspect
