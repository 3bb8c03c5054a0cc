// Fresh views, recognised.
#pragma once

#include "tools/eval/evaluation.h"
#include "tools/explain/faces.h"

namespace aspect {

// A contour of the frame and the one of the answer's aspect that it was taken for, by the faces
// that they mostly show.
struct MatchedFaces {
  std::vector<std::size_t> seen, believed;
};

struct Trial {
  ViewOutcome outcome;
  bool found = false;
  bool right_aspect = false;  // the best answer's, modulo symmetry
  std::int32_t found_class = kNoClass;
  Eigen::Vector3d found_view{0, 0, 1};
  std::vector<MatchedFaces> contours;

  bool is_wrong() const { return !right_aspect && outcome.error_deg > kFar_deg; }
  static constexpr double kFar_deg = 20;
};

std::vector<Trial> run_trials(const EvaluatedObject& object, const Faces& faces,
                              const ExplainSettings& settings);

Accuracy accuracy_of(const std::vector<Trial>& trials);

}  // namespace aspect
