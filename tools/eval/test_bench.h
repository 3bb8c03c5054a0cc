// Rendered views through a recogniser, and how right its answers are.
#pragma once

#include <memory>
#include <span>

#include "compiler/render/sensor.h"
#include "runtime/recognition/sized_recogniser.h"
#include "tools/eval/evaluation.h"

namespace aspect {

// The object is alone in its views: one blob, as the compiler sees.
class TestBench {
 public:
  TestBench(std::span<const ClassIndex> indexes, const EvaluationSettings& settings);

  // The result lives until the next call.
  Recognition recognise(const EvaluatedObject& object, const Eigen::Vector3d& direction);

  // Of the last view.
  const Picture& picture() const { return picture_; }
  const RegionMap& regions() const { return recogniser_.regions(); }

 private:
  SizedRecogniser recogniser_;
  std::unique_ptr<Sensor> sensor_;
  Picture picture_;
};

// Of the object seen, best first; none where nothing was seen.
std::span<const Hypothesis> hypotheses_of(const Recognition& recognition);

// Modulo the object's rotations.
double error_deg(const EvaluatedObject& object, const Eigen::Vector3d& truth, const Vector3& found);

ViewOutcome judge(const EvaluatedObject& object, const ClassSymmetry& symmetry,
                  const Eigen::Vector3d& direction, const Recognition& recognition);

double milliseconds(std::chrono::nanoseconds duration);

}  // namespace aspect
