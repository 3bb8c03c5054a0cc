// Recursive descent over sums, products and brackets. A value is a number until it shows to be
// the first of a vector's three; weak side: a vector outside brackets cannot begin a number field
// (`radius 1 0 0 dot 0 1 0` needs brackets).
#include "compiler/scene/bob_numbers.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <system_error>

#include "runtime/base/nearest_word.h"

namespace aspect {
namespace {

// Bounds the recursion, which is the program's own stack.
constexpr int kMaxDepth = 64;
constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180.0;

constexpr std::array<std::string_view, 8> kFunctions = {"sin",  "cos",  "tan",  "asin",
                                                        "acos", "atan", "sqrt", "pow"};

bool is_function(const BobWord& word) {
  return std::find(kFunctions.begin(), kFunctions.end(), word.text) != kFunctions.end();
}

bool is_sign(const BobWord& word) {
  return word.text == "+" || word.text == "-";
}

bool is_not_finite_name(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower == "nan" || lower == "inf" || lower == "infinity";
}

double value_of_function(std::string_view name, double x) {
  if (name == "sin") return sin_deg(x);
  if (name == "cos") return cos_deg(x);
  if (name == "tan") return sin_deg(x) / cos_deg(x);
  if (name == "asin") return std::asin(x) / kRadiansPerDegree;
  if (name == "acos") return std::acos(x) / kRadiansPerDegree;
  if (name == "atan") return std::atan(x) / kRadiansPerDegree;
  return std::sqrt(x);
}

}  // namespace

double sin_deg(double angle_deg) {
  const double turned = std::fmod(angle_deg, 360.0);
  if (std::fmod(turned, 180.0) == 0.0) return 0.0;
  if (turned == 90.0 || turned == -270.0) return 1.0;
  if (turned == 270.0 || turned == -90.0) return -1.0;
  return std::sin(turned * kRadiansPerDegree);
}

double cos_deg(double angle_deg) {
  const double turned = std::fabs(std::fmod(angle_deg, 360.0));
  if (turned == 90.0 || turned == 270.0) return 0.0;
  if (turned == 0.0) return 1.0;
  if (turned == 180.0) return -1.0;
  return std::cos(turned * kRadiansPerDegree);
}

double BobNumbers::number() {
  return scalar(Position::kAlone);
}

double BobNumbers::component() {
  return scalar(Position::kComponent);
}

Eigen::Vector3d BobNumbers::vector() {
  const BobWord first = words_.peek();
  Value value = sum(unary(), Position::kComponent);
  if (!value.is_vector) value = sum(completed(value), Position::kAlone);
  if (!value.is_vector) words_.fail(first, "a number in place of a vector; write three numbers");
  return in_range(value, first).vector;
}

Eigen::Vector3d BobNumbers::color() {
  in_color_ = true;
  const Eigen::Vector3d color = vector();
  in_color_ = false;
  return color;
}

std::variant<double, Eigen::Vector3d> BobNumbers::number_or_vector() {
  const BobWord first = words_.peek();
  Value value = sum(unary(), Position::kComponent);
  if (!value.is_vector && number_follows()) value = sum(completed(value), Position::kAlone);
  value = in_range(value, first);
  if (value.is_vector) return value.vector;
  return value.number;
}

double BobNumbers::scalar(Position position) {
  const BobWord first = words_.peek();
  const Value value = sum(unary(), position);
  return only_number(in_range(value, first), first);
}

bool BobNumbers::number_follows() const {
  const BobWord& word = words_.peek();
  return word.kind == BobWord::Kind::kNumber || word.text == "(" || is_sign(word) ||
         is_function(word);
}

BobNumbers::Value BobNumbers::completed(const Value& first) {
  const double second = scalar(Position::kComponent);
  const double third = scalar(Position::kLastComponent);
  return {true, 0, {first.number, second, third}};
}

bool BobNumbers::operator_follows(const Value& left, Position position) const {
  const BobWord& word = words_.peek();
  if (left.is_vector && (word.text == "cross" || word.text == "dot")) return true;
  if (!is_operator(word)) return false;
  if (left.is_vector || position == Position::kAlone) return true;
  if (is_sign(word) && word.space_before && !word.space_after) return false;
  return position != Position::kLastComponent || (!word.space_before && !word.after_macro);
}

BobNumbers::Value BobNumbers::sum(Value left, Position position) {
  left = product(left, position);
  while (operator_follows(left, position) && is_sign(words_.peek())) {
    const BobWord op = words_.take();
    left = combined(left, op, product(operand(left), position));
  }
  return left;
}

BobNumbers::Value BobNumbers::product(Value left, Position position) {
  while (operator_follows(left, position) && !is_sign(words_.peek())) {
    const BobWord op = words_.take();
    const bool by_vector = op.text == "cross" || op.text == "dot";
    left = combined(left, op, by_vector ? operand(left) : unary());
  }
  return left;
}

// What a vector is added to or crossed with may be three numbers without brackets.
BobNumbers::Value BobNumbers::operand(const Value& left) {
  const Value value = unary();
  if (!left.is_vector || value.is_vector) return value;
  const Value first = sum(value, Position::kComponent);
  return first.is_vector ? first : completed(first);
}

BobNumbers::Value BobNumbers::unary() {
  bool negative = false;
  while (is_sign(words_.peek())) {
    if (words_.take().text == "-") negative = !negative;
  }
  Value value = primary();
  if (!negative) return value;
  value.number = -value.number;
  value.vector = -value.vector;
  return value;
}

BobNumbers::Value BobNumbers::primary() {
  const BobWord word = words_.peek();
  if (word.kind == BobWord::Kind::kNumber) {
    words_.take();
    return {false, literal(word), Eigen::Vector3d::Zero()};
  }
  if (word.text != "(" && !is_function(word)) {
    if (is_not_finite_name(word.text)) {
      words_.fail(word, fmt::format("{} is not a finite number; write a finite one", quoted(word)));
    }
    if (in_color_ && word.kind == BobWord::Kind::kName) return missing_color(word);
    words_.fail(word, fmt::format("{} in place of a number; write a number", quoted(word)));
  }
  if (depth_ == kMaxDepth) {
    words_.fail(word, fmt::format("brackets more than {} deep; nest less", kMaxDepth));
  }
  ++depth_;
  words_.take();
  const Value value = word.text == "(" ? bracket() : function(word);
  words_.expect(")", "close the bracket");
  --depth_;
  return value;
}

BobNumbers::Value BobNumbers::missing_color(const BobWord& name) {
  const std::vector<std::string_view> macros = words_.macro_names();
  const std::string cure = macros.empty() ? "#define it, or #include the file that does"
                                          : fmt::format("#define it; the nearest name is '{}'",
                                                        nearest_word(name.text, macros));
  const Eigen::Vector3d color =
      lost_.stand_in(words_, name, fmt::format("the colour {} is not defined", quoted(name)), cure);
  // As if the numbers stood there, so that the scene can be read from its source.
  words_.take_as(fmt::format(" ( {} {} {} )", color.x(), color.y(), color.z()));
  return {true, 0, color};
}

BobNumbers::Value BobNumbers::bracket() {
  const Value value = sum(unary(), Position::kComponent);
  if (value.is_vector || words_.next_is(")")) return value;
  return sum(completed(value), Position::kAlone);
}

BobNumbers::Value BobNumbers::function(const BobWord& name) {
  words_.expect("(", fmt::format("write {}(...)", name.text));
  double result = 0;
  if (name.text == "pow") {
    const double base = scalar(Position::kComponent);
    result = std::pow(base, scalar(Position::kComponent));
  } else {
    result = value_of_function(name.text, scalar(Position::kAlone));
  }
  return in_range({false, result, Eigen::Vector3d::Zero()}, name);
}

BobNumbers::Value BobNumbers::combined(const Value& left, const BobWord& op,
                                       const Value& right) const {
  Value result;
  const bool both_vectors = left.is_vector && right.is_vector;
  const bool alike = left.is_vector == right.is_vector;
  result.is_vector = (left.is_vector || right.is_vector) && op.text != "dot";
  if (op.text == "cross" && both_vectors) {
    result.vector = left.vector.cross(right.vector);
  } else if (op.text == "dot" && both_vectors) {
    result.number = left.vector.dot(right.vector);
  } else if (op.text == "+" && alike) {
    result.vector = left.vector + right.vector;
    result.number = left.number + right.number;
  } else if (op.text == "-" && alike) {
    result.vector = left.vector - right.vector;
    result.number = left.number - right.number;
  } else if (op.text == "*" && !both_vectors) {
    result.number = left.number * right.number;
    result.vector =
        left.is_vector ? (left.vector * right.number).eval() : (right.vector * left.number).eval();
  } else if (op.text == "/" && !right.is_vector) {
    result.number = left.number / right.number;
    result.vector = left.is_vector ? (left.vector / right.number).eval() : Eigen::Vector3d::Zero();
  } else {
    words_.fail(
        op,
        fmt::format("'{}' between a {} and a {}; add like to like, multiply and divide by numbers",
                    op.text, left.is_vector ? "vector" : "number",
                    right.is_vector ? "vector" : "number"));
  }
  return in_range(result, op);
}

double BobNumbers::literal(const BobWord& word) const {
  double value = 0;
  const char* end = word.text.data() + word.text.size();
  const auto [read, code] = std::from_chars(word.text.data(), end, value);
  if (code == std::errc::result_out_of_range) {
    words_.fail(word, fmt::format("{} is no finite number a computer holds; write a number within "
                                  "+-{:g}",
                                  quoted(word), kMaxNumber));
  }
  if (code != std::errc{} || read != end) {
    words_.fail(word, fmt::format("{} is not a number; write it as in C, for example -1.5e-3",
                                  quoted(word)));
  }
  return value;
}

double BobNumbers::only_number(const Value& value, const BobWord& word) const {
  if (value.is_vector) words_.fail(word, "a vector in place of a number; write one number");
  return value.number;
}

BobNumbers::Value BobNumbers::in_range(const Value& value, const BobWord& word) const {
  const double largest = std::max(std::fabs(value.number), value.vector.cwiseAbs().maxCoeff());
  const bool is_nan = std::isnan(value.number) || value.vector.hasNaN();
  if (!is_nan && largest <= kMaxNumber) return value;
  const bool finite = !is_nan && std::isfinite(largest);
  words_.fail(word, fmt::format("the value is {}; write a number within +-{:g}",
                                finite ? fmt::format("{:g}", largest) : "not finite", kMaxNumber));
}

}  // namespace aspect
