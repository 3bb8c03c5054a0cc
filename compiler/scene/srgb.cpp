#include "compiler/scene/srgb.h"

#include <algorithm>
#include <cmath>

namespace aspect {
namespace {

using Eigen::Vector3d;

double encoded(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

double decoded(double srgb) {
  const double x = std::clamp(srgb, 0.0, 1.0);
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

}  // namespace

Vector3d srgb_of_linear(const Vector3d& linear) {
  return linear.unaryExpr([](double x) { return encoded(x); });
}

Vector3d linear_of_srgb(const Vector3d& srgb) {
  return srgb.unaryExpr([](double x) { return decoded(x); });
}

Vector3d srgb_of_xyz(const Vector3d& xyz) {
  Eigen::Matrix3d linear_from_xyz;
  linear_from_xyz << 3.2406, -1.5372, -0.4986, -0.9689, 1.8758, 0.0415, 0.0557, -0.2040, 1.0570;
  return srgb_of_linear(linear_from_xyz * xyz);
}

}  // namespace aspect
