// Numbers and vectors with Vivid's arithmetic.
//
// Signs: a + or - that follows white space and touches what follows starts the next number of a
// vector, so `vertex -2.5 0 +1.85` has three; `2 - 1` and `2-1` are differences. Where one number
// alone is wanted, `2 -1` is a difference as well.
// Operators behind the third number of a vector: with white space before them (or behind a
// macro) they belong to the vector, as in `RED * 0.5`; touching the number, to the number.
#pragma once

#include <Eigen/Core>
#include <variant>

#include "compiler/scene/bob_lost_colours.h"
#include "compiler/scene/bob_words.h"

namespace aspect {

// Degrees to sine and cosine, exact at multiples of 90.
double sin_deg(double angle_deg);
double cos_deg(double angle_deg);

// Throws BobError. Every number it gives is finite and within +-kMaxNumber.
class BobNumbers {
 public:
  // Squares and products of such numbers stay far inside a double.
  static constexpr double kMaxNumber = 1e9;

  BobNumbers(BobWords& words, BobLostColours& lost) : words_(words), lost_(lost) {}

  double number();
  // One number of several that follow each other.
  double component();
  Eigen::Vector3d vector();
  // A vector in which an unknown name is a colour that is missing.
  Eigen::Vector3d color();
  // Three numbers, or one where no second number follows.
  std::variant<double, Eigen::Vector3d> number_or_vector();

 private:
  struct Value {
    bool is_vector = false;
    double number = 0;
    Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  };

  enum class Position { kAlone, kComponent, kLastComponent };

  Value sum(Value left, Position position);
  Value product(Value left, Position position);
  Value operand(const Value& left);
  Value unary();
  Value primary();
  Value bracket();
  Value missing_color(const BobWord& name);
  Value function(const BobWord& name);
  Value completed(const Value& first);
  double scalar(Position position);
  bool operator_follows(const Value& left, Position position) const;
  bool number_follows() const;
  Value combined(const Value& left, const BobWord& op, const Value& right) const;
  double literal(const BobWord& word) const;
  double only_number(const Value& value, const BobWord& word) const;
  Value in_range(const Value& value, const BobWord& word) const;

  BobWords& words_;
  BobLostColours& lost_;
  bool in_color_ = false;
  int depth_ = 0;
};

}  // namespace aspect
