#include "tools/eval/test_bench.h"

#include <numbers>

#include "tools/eval/view_error.h"

namespace aspect {
namespace {

RecogniserParameters parameters_for(std::span<const ClassIndex> indexes,
                                    const EvaluationSettings& settings,
                                    const std::optional<CalibratedCamera>& camera) {
  RecogniserParameters parameters;
  parameters.camera = camera;
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

// Parallel rays do not tell the distance.
std::optional<PoseError> pose_error_of(const EvaluatedObject& object,
                                       const Eigen::Vector3d& direction,
                                       std::span<const Hypothesis> hypotheses) {
  if (hypotheses.empty() || hypotheses.front().pose == nullptr) return std::nullopt;
  const Camera camera = camera_at(object.scene.studio, direction);
  if (camera.intrinsics.projection != Projection::kPerspective) return std::nullopt;
  return pose_error(object.index, camera.intrinsics,
                    true_pose(camera, object.scene.source_from_object),
                    hypotheses.front().pose->refined.pose);
}

}  // namespace

std::optional<CalibratedCamera> common_lens(std::span<const EvaluatedObject> objects) {
  const auto lens_of = [](const Studio& studio) -> std::optional<std::array<double, 5>> {
    if (!studio.lens) return std::nullopt;
    const Lens& lens = *studio.lens;
    return {{lens.fx_px, lens.fy_px, lens.cx_px, lens.cy_px, static_cast<double>(studio.width_px)}};
  };
  const auto first = lens_of(objects.front().scene.studio);
  for (const EvaluatedObject& object : objects)
    if (lens_of(object.scene.studio) != first) return std::nullopt;
  if (!first) return std::nullopt;
  const auto& [fx, fy, cx, cy, width] = *first;
  return CalibratedCamera{{fx, fy, cx, cy}, static_cast<int>(width)};
}

TestBench::TestBench(std::span<const ClassIndex> indexes, const EvaluationSettings& settings,
                     const std::optional<CalibratedCamera>& camera)
    : recogniser_(indexes, parameters_for(indexes, settings, camera)),
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

JudgedView judged_view(const Recognition& recognition, std::size_t truth) {
  if (recognition.objects.empty()) return {};
  const SeenObject& seen = recognition.objects.front();
  return {seen.judgement.verdict, static_cast<double>(seen.judgement.probability),
          !seen.hypotheses.empty() && seen.hypotheses.front().index == truth};
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
  outcome.pose = pose_error_of(object, direction, hypotheses);
  outcome.judged = judged_view(recognition, 0);
  return outcome;
}

}  // namespace aspect
