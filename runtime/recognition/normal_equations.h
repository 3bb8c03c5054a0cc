// Weighted least squares in six unknowns: three turns and three shifts.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace aspect {

class NormalEquations {
 public:
  // One equation: slope * step = target.
  void add(const std::array<double, 6>& slope, double target, double weight);

  // The step, damped as Levenberg and Marquardt do; `size` is what a turn of one radian counts as
  // beside a shift. Nothing where the equations do not hold together.
  std::optional<std::array<double, 6>> solve(double size) const;

  // Of the step, where targets have this variance; row by row. Directions in which nothing was
  // measured get a large one.
  std::array<double, 36> covariance(double variance, double size) const;

 private:
  std::array<double, 36> damped(double size) const;

  std::array<double, 36> matrix_{};
  std::array<double, 6> right_{};
};

}  // namespace aspect
