// Rendered views through a recogniser, and how right its answers are.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "compiler/render/sensor.h"
#include "runtime/recognition/sized_recogniser.h"
#include "tools/eval/evaluation.h"

namespace aspect {

// The lens that all objects are seen with; nothing where it is not known, or they have several.
std::optional<CalibratedCamera> common_lens(std::span<const EvaluatedObject> objects);

// The object is alone in its views: one blob, as the compiler sees.
class TestBench {
 public:
  TestBench(std::span<const ClassIndex> indexes, const EvaluationSettings& settings,
            const std::optional<CalibratedCamera>& camera = {});

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

// `truth` is the place of the object's index.
JudgedView judged_view(const Recognition& recognition, std::size_t truth);

// With the object's own index.
ViewOutcome judge(const EvaluatedObject& object, const ClassSymmetry& symmetry,
                  const Eigen::Vector3d& direction, const Recognition& recognition);

double milliseconds(std::chrono::nanoseconds duration);

}  // namespace aspect
