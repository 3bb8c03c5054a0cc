#include "compiler/scene/bob_transforms.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <variant>

#include "runtime/base/nearest_word.h"

namespace aspect {
namespace {

constexpr std::array<std::string_view, 3> kSteps = {"translate", "rotate", "scale"};

// Far above any real scene.
constexpr std::size_t kMaxDepth = 100;

// Factors differ by rounding even where a scene means them to be equal.
constexpr double kUniformTolerance = 1e-9;

Eigen::Matrix3d rotation_about(int axis, double angle_deg) {
  const int next = (axis + 1) % 3;
  const int last = (axis + 2) % 3;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  rotation(next, next) = rotation(last, last) = cos_deg(angle_deg);
  rotation(last, next) = sin_deg(angle_deg);
  rotation(next, last) = -rotation(last, next);
  return rotation;
}

}  // namespace

const Eigen::Affine3d& BobTransforms::scene_from_written() const {
  static const Eigen::Affine3d kIdentity = Eigen::Affine3d::Identity();
  return levels_.empty() ? kIdentity : levels_.back().scene_from_written;
}

void BobTransforms::push(const BobWord& statement) {
  if (levels_.size() == kMaxDepth) {
    words_.fail(statement,
                fmt::format("transforms more than {} deep; write transform_pop", kMaxDepth));
  }
  words_.expect("{", "write transform { translate x y z ... }");
  Eigen::Affine3d own = Eigen::Affine3d::Identity();
  while (!words_.next_is("}")) {
    const Eigen::Affine3d step = read_step(words_.take());
    own = step * own;
  }
  words_.take();
  const Eigen::Affine3d total = scene_from_written() * own;
  const double determinant = total.linear().determinant();
  if (!total.matrix().allFinite() || !std::isfinite(determinant) || determinant == 0) {
    words_.fail(statement,
                "the transforms together are too large or too small to compute with; "
                "scale less");
  }
  levels_.push_back({total, statement});
}

Eigen::Affine3d BobTransforms::read_step(const BobWord& word) {
  Eigen::Affine3d step = Eigen::Affine3d::Identity();
  if (word.text == "translate") {
    step.translation() = numbers_.vector();
  } else if (word.text == "rotate") {
    const Eigen::Vector3d angles_deg = numbers_.vector();
    step.linear() = rotation_about(2, angles_deg.z()) * rotation_about(1, angles_deg.y()) *
                    rotation_about(0, angles_deg.x());
  } else if (word.text == "scale") {
    const auto read = numbers_.number_or_vector();
    const double* all = std::get_if<double>(&read);
    const Eigen::Vector3d factors =
        all != nullptr ? Eigen::Vector3d::Constant(*all) : std::get<Eigen::Vector3d>(read);
    if ((factors.array() == 0).any()) {
      words_.fail(word, "scale 0 flattens the object; write a factor other than 0");
    }
    step.linear() = factors.asDiagonal();
  } else {
    words_.fail(word, fmt::format("unknown word {} in transform; the nearest known one is '{}'",
                                  quoted(word), nearest_word(word.text, kSteps)));
  }
  return step;
}

void BobTransforms::pop(const BobWord& statement) {
  if (levels_.empty()) {
    words_.fail(statement, "transform_pop without a transform; write transform { ... } before it");
  }
  levels_.pop_back();
}

void BobTransforms::finish() const {
  if (levels_.empty()) return;
  words_.fail(levels_.back().opened, "this transform is never popped; write transform_pop");
}

std::optional<double> BobTransforms::length_factor() const {
  const Eigen::Matrix3d linear = scene_from_written().linear();
  const double factor = linear.col(0).norm();
  // Divided first, so that small factors do not underflow when squared.
  const Eigen::Matrix3d unit = linear / factor;
  const Eigen::Matrix3d deviation = unit.transpose() * unit - Eigen::Matrix3d::Identity();
  if (!(deviation.cwiseAbs().maxCoeff() <= kUniformTolerance)) return std::nullopt;
  return factor;
}

}  // namespace aspect
