#include "tools/eval/test_bench.h"

#include <numbers>

#include "tools/eval/view_error.h"

namespace aspect {
namespace {

RecogniserParameters parameters_for(std::span<const ClassIndex> indexes,
                                    const EvaluationSettings& settings) {
  RecogniserParameters parameters;
  parameters.vision = indexes.front().vision;
  parameters.vision.one_blob = true;
  parameters.matching = settings.matching;
  parameters.ranking = settings.ranking;
  parameters.top = kMaxHypotheses;
  return parameters;
}

template <typename Same>
int rank_of(std::span<const Hypothesis> hypotheses, const Same& is_right) {
  for (std::size_t k = 0; k < hypotheses.size(); ++k)
    if (is_right(static_cast<std::int32_t>(hypotheses[k].class_id))) return static_cast<int>(k) + 1;
  return 0;
}

}  // namespace

TestBench::TestBench(std::span<const ClassIndex> indexes, const EvaluationSettings& settings)
    : recogniser_(indexes, parameters_for(indexes, settings)),
      sensor_(make_sensor(indexes.front().vision)) {}

Recognition TestBench::recognise(const EvaluatedObject& object, const Eigen::Vector3d& direction) {
  object.renderer.render(camera_at(object.scene.studio, direction), picture_);
  recogniser_.make_room(picture_.width_px, picture_.height_px);
  return recogniser_.recognise(sensor_->frame_of(picture_));
}

std::span<const Hypothesis> hypotheses_of(const Recognition& recognition) {
  if (recognition.objects.empty()) return {};
  return recognition.objects.front().hypotheses;
}

double milliseconds(std::chrono::nanoseconds duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

double error_deg(const EvaluatedObject& object, const Eigen::Vector3d& truth,
                 const Vector3& found) {
  const Eigen::Vector3d view =
      Eigen::Vector3f(found[0], found[1], found[2]).cast<double>().normalized();
  return view_error_rad(object.rotations, truth, view) * 180 / std::numbers::pi;
}

ViewOutcome judge(const EvaluatedObject& object, const ClassSymmetry& symmetry,
                  const Eigen::Vector3d& direction, const Recognition& recognition) {
  ViewOutcome outcome;
  outcome.direction = direction;
  outcome.right_class = object.views.right(direction);
  outcome.elapsed_ms = milliseconds(recognition.elapsed);
  const auto hypotheses = hypotheses_of(recognition);
  const std::int32_t right = outcome.right_class;
  outcome.rank = rank_of(hypotheses, [&](std::int32_t c) { return c == right; });
  outcome.rank_with_symmetry =
      rank_of(hypotheses, [&](std::int32_t c) { return symmetry.same(right, c); });
  if (!hypotheses.empty())
    outcome.error_deg = error_deg(object, direction, hypotheses.front().view);
  return outcome;
}

}  // namespace aspect
