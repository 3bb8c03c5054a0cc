#include "tools/eval/evaluation_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace aspect {
namespace {

using Json = nlohmann::ordered_json;

Json error_json(const ErrorSummary& error) {
  return {{"median", error.median_deg},
          {"mean", error.mean_deg},
          {"p90", error.p90_deg},
          {"percent_within_5", 100 * error.within_5},
          {"percent_within_10", 100 * error.within_10},
          {"percent_within_20", 100 * error.within_20}};
}

Json spread_json(const ErrorSpread& spread) {
  return {{"median", spread.median}, {"p90", spread.p90}, {"within_5", spread.within_5}};
}

Json reliability_json(const Reliability& reliability) {
  const auto right = reliability.right_match_share(),
             error = reliability.expected_calibration_error();
  Json json{{"match", reliability.matches},
            {"ambiguous", reliability.ambiguous},
            {"unknown", reliability.unknown},
            {"not_judged", reliability.not_judged},
            {"percent_matches_right", right ? Json(100 * *right) : Json()},
            {"expected_calibration_error", error ? Json(*error) : Json()},
            {"bins", Json::array()}};
  for (const ReliabilityBin& bin : reliability.bins)
    json["bins"].push_back({{"count", bin.count},
                            {"mean_probability", bin.mean_probability},
                            {"right_share", bin.right_share}});
  return json;
}

const char* verdict_name(Verdict verdict) {
  constexpr std::array kNames = {"none", "match", "ambiguous", "unknown"};
  return kNames.at(static_cast<std::size_t>(verdict));
}

Json ranks_json(const std::array<double, kReportedRanks.size()>& shares) {
  Json json;
  for (std::size_t k = 0; k < shares.size(); ++k)
    json[fmt::format("{}", kReportedRanks[k])] = 100 * shares[k];
  return json;
}

Json object_json(const ObjectEvaluation& object) {
  Json json{{"object", object.object},
            {"index_bytes", object.index_bytes},
            {"classes", object.classes},
            {"area_fraction", object.area_fraction},
            {"rotations", object.rotations},
            {"percent_uncovered", 100 * object.uncovered_share},
            {"percent_nothing_found", 100 * object.nothing_found},
            {"percent_right", ranks_json(object.right)},
            {"percent_right_with_symmetry", ranks_json(object.right_with_symmetry)},
            {"view_error_deg", error_json(object.error)},
            {"pose", poses_json(object.pose)},
            {"reliability", reliability_json(object.reliability)},
            {"elapsed_ms", {{"mean", object.mean_ms}, {"median", object.median_ms}}},
            {"views", Json::array()}};
  for (const ViewOutcome& outcome : object.outcomes)
    json["views"].push_back(
        {{"view", {outcome.direction.x(), outcome.direction.y(), outcome.direction.z()}},
         {"class", outcome.right_class},
         {"rank", outcome.rank},
         {"rank_with_symmetry", outcome.rank_with_symmetry},
         {"error_deg", outcome.error_deg},
         {"pose_error", pose_error_json(outcome.pose)},
         {"verdict", verdict_name(outcome.judged.verdict)},
         {"probability", outcome.judged.probability},
         {"elapsed_ms", outcome.elapsed_ms}});
  return json;
}

Json confusion_json(const Evaluation& evaluation) {
  Json rows = Json::array();
  for (std::size_t truth = 0; truth < evaluation.objects.size(); ++truth) {
    Json found;
    const std::vector<int>& counts = evaluation.confusion->counts[truth];
    for (std::size_t k = 0; k < evaluation.objects.size(); ++k)
      found[evaluation.objects[k].object] = counts[k];
    rows.push_back({{"object", evaluation.objects[truth].object},
                    {"found", std::move(found)},
                    {"found_none", counts.back()},
                    {"view_error_deg", error_json(evaluation.confusion->error[truth])},
                    {"elapsed_ms", {{"median", evaluation.confusion->median_ms[truth]}}},
                    {"reliability", reliability_json(evaluation.confusion->reliability[truth])}});
  }
  return rows;
}

}  // namespace

Json poses_json(const std::optional<PoseSummary>& pose) {
  if (!pose) return nullptr;
  return {{"percent_found", 100 * pose->found_share},
          {"rotation_deg", spread_json(pose->rotation_deg)},
          {"translation_percent", spread_json(pose->translation_percent)},
          {"reprojection_px", spread_json(pose->reprojection_px)}};
}

Json pose_error_json(const std::optional<PoseError>& error) {
  if (!error) return nullptr;
  return {{"rotation_deg", error->rotation_deg},
          {"translation_percent", error->translation_percent},
          {"reprojection_px", error->reprojection_px}};
}

std::string evaluation_json(const Evaluation& evaluation) {
  const EvaluationSettings& settings = evaluation.settings;
  const bool by_views = settings.ranking == RecogniserParameters::Ranking::views;
  Json json{{"views", settings.views},
            {"seed", settings.seed},
            {"matching", settings.matching == Matching::simple ? "simple" : "weighted"},
            {"ranking", by_views ? "views" : "classes"},
            {"objects", Json::array()}};
  for (const ObjectEvaluation& object : evaluation.objects)
    json["objects"].push_back(object_json(object));
  if (evaluation.confusion) {
    json["confusion"] = confusion_json(evaluation);
    json["reliability"] = reliability_json(evaluation.confusion->total_reliability);
  }
  return json.dump(1) + "\n";
}

}  // namespace aspect
