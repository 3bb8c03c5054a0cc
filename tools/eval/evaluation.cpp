#include "tools/eval/evaluation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "tools/aspectc/project/prepared_object.h"
#include "tools/eval/random_directions.h"
#include "tools/eval/test_bench.h"
#include "tools/eval/view_error.h"

namespace aspect {
namespace {

template <typename Test>
double share_with(const std::vector<ViewOutcome>& outcomes, const Test& test) {
  return static_cast<double>(std::count_if(outcomes.begin(), outcomes.end(), test)) /
         static_cast<double>(outcomes.size());
}

double mean(const std::vector<double>& values) {
  if (values.empty()) return 0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

ErrorSummary summarise(const std::vector<double>& errors_deg) {
  const auto within = [&](double most) {
    const auto count = std::count_if(errors_deg.begin(), errors_deg.end(),
                                     [&](double error) { return error <= most; });
    return static_cast<double>(count) /
           static_cast<double>(std::max<std::size_t>(1, errors_deg.size()));
  };
  return {percentile(errors_deg, 0.5),
          mean(errors_deg),
          percentile(errors_deg, 0.9),
          within(5),
          within(10),
          within(20)};
}

ErrorSpread spread_of(const std::vector<double>& errors, std::size_t views) {
  const auto within = std::count_if(errors.begin(), errors.end(), [](double e) { return e <= 5; });
  return {percentile(errors, 0.5), percentile(errors, 0.9),
          static_cast<double>(within) / static_cast<double>(views)};
}

void summarise(ObjectEvaluation& evaluation) {
  const auto& outcomes = evaluation.outcomes;
  for (std::size_t k = 0; k < kReportedRanks.size(); ++k) {
    const int most = kReportedRanks[k];
    const auto counts = [&](int rank) { return rank >= 1 && rank <= most; };
    evaluation.right[k] = share_with(outcomes, [&](const auto& o) { return counts(o.rank); });
    evaluation.right_with_symmetry[k] =
        share_with(outcomes, [&](const auto& o) { return counts(o.rank_with_symmetry); });
  }
  std::vector<double> errors, times;
  std::vector<JudgedView> judged;
  for (const ViewOutcome& outcome : outcomes) {
    errors.push_back(outcome.error_deg);
    judged.push_back(outcome.judged);
    times.push_back(outcome.elapsed_ms);
  }
  evaluation.error = summarise(errors);
  evaluation.pose = summarise_poses(outcomes);
  evaluation.reliability = reliability_of(judged);
  evaluation.mean_ms = mean(times);
  evaluation.median_ms = percentile(times, 0.5);
}

}  // namespace

Result<EvaluatedObject> EvaluatedObject::load(const std::filesystem::path& index_file,
                                              const std::filesystem::path& scene_file) {
  Result<ClassIndex> index = load_index(index_file);
  if (!index) return Error{index.error()};
  return create(index_file, std::move(index).value(), scene_file);
}

Result<EvaluatedObject> EvaluatedObject::create(const std::filesystem::path& index_file,
                                                ClassIndex index,
                                                const std::filesystem::path& scene_file) {
  Result<Scene> scene = read_prepared_scene(scene_file);
  if (!scene) return Error{scene.error()};
  return of(std::move(index), index_file.native(), std::move(scene).value());
}

Result<EvaluatedObject> EvaluatedObject::of(ClassIndex index, const std::string& index_file,
                                            Scene scene) {
  Result<Renderer> renderer = Renderer::create(scene);
  if (!renderer) return Error{scene.file + ": " + renderer.error()};
  Result<ClassViews> views = ClassViews::create(index);
  if (!views) return Error{index_file + ": " + views.error()};
  std::vector<Eigen::Matrix3d> rotations = index_rotations(index);
  return EvaluatedObject{index_file,
                         std::move(index),
                         std::move(scene),
                         std::move(renderer).value(),
                         std::move(views).value(),
                         std::move(rotations)};
}

ObjectEvaluation evaluate_object(const EvaluatedObject& object,
                                 const EvaluationSettings& settings) {
  ObjectEvaluation evaluation;
  evaluation.object = object.index.object;
  evaluation.classes = object.index.classes.size();
  evaluation.index_bytes = object.index.file_bytes;
  evaluation.rotations = object.rotations.size();
  for (const AspectClass& aspect : object.index.classes)
    evaluation.area_fraction += static_cast<double>(aspect.area_fraction);
  const ClassSymmetry symmetry(object.index, object.views, object.rotations);
  TestBench bench({&object.index, 1}, settings, common_lens({&object, 1}));
  int uncovered = 0, nothing = 0;
  for (const Eigen::Vector3d& direction :
       random_directions(static_cast<std::size_t>(settings.views), settings.seed)) {
    const Recognition recognition = bench.recognise(object, direction);
    evaluation.outcomes.push_back(judge(object, symmetry, direction, recognition));
    uncovered += object.views.at(direction) == kNoClass ? 1 : 0;
    nothing += hypotheses_of(recognition).empty() ? 1 : 0;
  }
  evaluation.uncovered_share = static_cast<double>(uncovered) / settings.views;
  evaluation.nothing_found = static_cast<double>(nothing) / settings.views;
  summarise(evaluation);
  return evaluation;
}

Confusion evaluate_confusion(std::span<const EvaluatedObject> objects,
                             const EvaluationSettings& settings) {
  std::vector<ClassIndex> indexes;
  for (const EvaluatedObject& object : objects) indexes.push_back(object.index);
  const auto directions =
      random_directions(static_cast<std::size_t>(settings.views), settings.seed);
  TestBench bench(indexes, settings, common_lens(objects));
  Confusion confusion;
  std::vector<JudgedView> all_judged;
  for (std::size_t truth = 0; truth < objects.size(); ++truth) {
    std::vector<int> counts(objects.size() + 1, 0);
    std::vector<double> errors, times;
    std::vector<JudgedView> judged;
    for (const Eigen::Vector3d& direction : directions) {
      const Recognition recognition = bench.recognise(objects[truth], direction);
      const auto hypotheses = hypotheses_of(recognition);
      const std::size_t found = hypotheses.empty() ? objects.size() : hypotheses.front().index;
      ++counts[found];
      errors.push_back(
          found == truth ? error_deg(objects[truth], direction, hypotheses.front().view) : 180);
      times.push_back(milliseconds(recognition.elapsed));
      judged.push_back(judged_view(recognition, truth));
    }
    confusion.counts.push_back(std::move(counts));
    confusion.error.push_back(summarise(errors));
    confusion.median_ms.push_back(percentile(times, 0.5));
    confusion.reliability.push_back(reliability_of(judged));
    all_judged.insert(all_judged.end(), judged.begin(), judged.end());
  }
  confusion.total_reliability = reliability_of(all_judged);
  return confusion;
}

std::optional<PoseSummary> summarise_poses(std::span<const ViewOutcome> outcomes) {
  std::vector<double> rotations_deg, translations_percent, reprojections_px;
  for (const ViewOutcome& outcome : outcomes) {
    if (!outcome.pose) continue;
    rotations_deg.push_back(outcome.pose->rotation_deg);
    translations_percent.push_back(outcome.pose->translation_percent);
    reprojections_px.push_back(outcome.pose->reprojection_px);
  }
  if (rotations_deg.empty()) return std::nullopt;
  const std::size_t views = outcomes.size();
  return PoseSummary{static_cast<double>(rotations_deg.size()) / static_cast<double>(views),
                     spread_of(rotations_deg, views), spread_of(translations_percent, views),
                     spread_of(reprojections_px, views)};
}

const Reliability& overall_reliability(const Evaluation& evaluation) {
  return evaluation.confusion ? evaluation.confusion->total_reliability
                              : evaluation.objects.front().reliability;
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - std::floor(place)) * (values[above] - values[below]);
}

}  // namespace aspect
