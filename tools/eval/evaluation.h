// The thesis's experiments with simulated images (4.4) as numbers.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/render/renderer.h"
#include "compiler/scene/scene.h"
#include "runtime/base/result.h"
#include "runtime/recognition/recogniser.h"
#include "tools/eval/class_views.h"
#include "tools/eval/pose_error.h"
#include "tools/eval/reliability.h"

namespace aspect {

// An object as it is put to the test.
struct EvaluatedObject {
  std::string index_file;
  ClassIndex index;
  Scene scene;
  Renderer renderer;
  ClassViews views;
  std::vector<Eigen::Matrix3d> rotations;  // that leave it as it is; the identity first

  static Result<EvaluatedObject> load(const std::filesystem::path& index,
                                      const std::filesystem::path& scene);
  // With an index that is loaded; its file is named in messages.
  static Result<EvaluatedObject> create(const std::filesystem::path& index_file, ClassIndex index,
                                        const std::filesystem::path& scene);
  static Result<EvaluatedObject> of(ClassIndex index, const std::string& index_file, Scene scene);
};

inline constexpr std::array<int, 5> kReportedRanks = {1, 2, 3, 5, 10};

// Of one view with the object's own index.
struct ViewOutcome {
  Eigen::Vector3d direction;
  std::int32_t right_class = kNoClass;
  int rank = 0, rank_with_symmetry = 0;  // from 1; 0: not among the hypotheses
  double error_deg = 180;                // of the best hypothesis, modulo the rotations
  std::optional<PoseError> pose;         // of the best hypothesis; nothing where it has none
  JudgedView judged;
  double elapsed_ms = 0;
};

struct ErrorSummary {
  double median_deg = 0, mean_deg = 0, p90_deg = 0;
  double within_5 = 0, within_10 = 0, within_20 = 0;  // shares of the views
};

// Of the views with a pose; what is within 5 degrees, per cent or pixels is a share of all views.
struct ErrorSpread {
  double median = 0, p90 = 0, within_5 = 0;
};

struct PoseSummary {
  double found_share = 0;  // of the views, that have a pose
  ErrorSpread rotation_deg, translation_percent, reprojection_px;
};

struct ObjectEvaluation {
  std::string object;
  std::size_t classes = 0, index_bytes = 0, rotations = 0;
  double area_fraction = 0;    // of the sphere that the classes cover
  double uncovered_share = 0;  // of the views, from where no class is the right one for certain
  double nothing_found = 0;    // share of the views without a hypothesis
  std::array<double, kReportedRanks.size()> right{}, right_with_symmetry{};  // accumulated shares
  ErrorSummary error;
  std::optional<PoseSummary> pose;  // nothing where no view has one
  Reliability reliability;
  double mean_ms = 0, median_ms = 0;
  std::vector<ViewOutcome> outcomes;
};

// Thesis 4.4.2: all indexes at once; which object comes first.
struct Confusion {
  // by true object, then by object found; behind the last object: none
  std::vector<std::vector<int>> counts;
  std::vector<ErrorSummary> error;       // by true object; 180 where another one was found
  std::vector<double> median_ms;         // by true object
  std::vector<Reliability> reliability;  // by true object
  Reliability total_reliability;
};

struct EvaluationSettings {
  int views = 100;
  std::uint64_t seed = 1;
  Matching matching = Matching::weighted;
  RecogniserParameters::Ranking ranking = RecogniserParameters::Ranking::views;
};

struct Evaluation {
  EvaluationSettings settings;
  std::vector<ObjectEvaluation> objects;
  std::optional<Confusion> confusion;  // where there are several objects
};

ObjectEvaluation evaluate_object(const EvaluatedObject& object, const EvaluationSettings& settings);
Confusion evaluate_confusion(std::span<const EvaluatedObject> objects,
                             const EvaluationSettings& settings);

// Of at least one view.
std::optional<PoseSummary> summarise_poses(std::span<const ViewOutcome> outcomes);

// With all indexes at once where there are several, otherwise of the only object.
const Reliability& overall_reliability(const Evaluation& evaluation);

// Of any values; with none all is 0. Percentiles are interpolated as NumPy does.
double percentile(std::vector<double> values, double share);

}  // namespace aspect
