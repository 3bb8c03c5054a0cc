#include "runtime/recognition/normal_equations.h"

#include <cmath>

namespace aspect {
namespace {

constexpr std::size_t kUnknowns = 6;
using Matrix6 = std::array<double, 36>;
using Vector6 = std::array<double, 6>;

// Lower triangle of Cholesky's; false where the matrix is not positive definite.
bool factorise(Matrix6& m) {
  for (std::size_t row = 0; row < kUnknowns; ++row)
    for (std::size_t column = 0; column <= row; ++column) {
      double sum = m[row * kUnknowns + column];
      for (std::size_t k = 0; k < column; ++k)
        sum -= m[row * kUnknowns + k] * m[column * kUnknowns + k];
      if (row == column) {
        if (!(sum > 0)) return false;
        m[row * kUnknowns + row] = std::sqrt(sum);
      } else {
        m[row * kUnknowns + column] = sum / m[column * kUnknowns + column];
      }
    }
  return true;
}

Vector6 solved(const Matrix6& lower, Vector6 x) {
  for (std::size_t row = 0; row < kUnknowns; ++row) {
    for (std::size_t k = 0; k < row; ++k) x[row] -= lower[row * kUnknowns + k] * x[k];
    x[row] /= lower[row * kUnknowns + row];
  }
  for (std::size_t row = kUnknowns; row-- > 0;) {
    for (std::size_t k = row + 1; k < kUnknowns; ++k) x[row] -= lower[k * kUnknowns + row] * x[k];
    x[row] /= lower[row * kUnknowns + row];
  }
  return x;
}

}  // namespace

void NormalEquations::add(const Vector6& slope, double target, double weight) {
  for (std::size_t row = 0; row < kUnknowns; ++row) {
    const double w = weight * slope[row];
    for (std::size_t column = 0; column <= row; ++column)
      matrix_[row * kUnknowns + column] += w * slope[column];
    right_[row] += w * target;
  }
}

// Keeps what is hardly measured from running away: a share of the mean information on a shift, and
// on a turn the same times the size's square.
Matrix6 NormalEquations::damped(double size) const {
  constexpr double kDamping = 1e-3;
  Matrix6 m = matrix_;
  double shifts = 0;
  for (std::size_t k = 3; k < kUnknowns; ++k) shifts += matrix_[k * kUnknowns + k] / 3;
  for (std::size_t k = 0; k < kUnknowns; ++k)
    m[k * kUnknowns + k] += kDamping * shifts * (k < 3 ? size * size : 1.0);
  return m;
}

std::optional<Vector6> NormalEquations::solve(double size) const {
  Matrix6 m = damped(size);
  if (!factorise(m)) return std::nullopt;
  return solved(m, right_);
}

Matrix6 NormalEquations::covariance(double variance, double size) const {
  Matrix6 m = damped(size), result{};
  if (!factorise(m)) return result;
  for (std::size_t column = 0; column < kUnknowns; ++column) {
    Vector6 unit{};
    unit[column] = variance;
    const Vector6 x = solved(m, unit);
    for (std::size_t row = 0; row < kUnknowns; ++row) result[row * kUnknowns + column] = x[row];
  }
  return result;
}

}  // namespace aspect
